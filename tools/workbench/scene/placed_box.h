// A box put into a scene: place_box() of motions.h.
#pragma once

namespace lanthorn::workbench {

// Of the node that holds it.
inline constexpr const char* kBoxName = "measured-box";

}  // namespace lanthorn::workbench
