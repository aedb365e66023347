// The commands stand on lanthorn::workbench and call its parts by their plain names.
#pragma once

namespace lanthorn::workbench {}

namespace lanthorn::tools {
using namespace workbench;
}
