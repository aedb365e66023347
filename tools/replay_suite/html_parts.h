// Pieces of the suite's page that are text only: its head, style and script.
#pragma once

namespace lanthorn::suite {

extern const char* const kPageStyle;
extern const char* const kPageScript;

}  // namespace lanthorn::suite
