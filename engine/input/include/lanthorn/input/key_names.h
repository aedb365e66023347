// What to press for an action, in words that fit on a screen.
#pragma once

#include <string>

#include "lanthorn/input/bindings.h"

namespace lanthorn::input {

// "Esc", "E", "A": on the gamepad (`pad`), or on keyboard and mouse; where nothing is bound there, on the
// other one. Empty: nothing is.
std::string key_name(const Bindings& bindings, ActionId action, bool pad);

// All of one device, "R, Wheel Up", those of the gamepad without "Pad". Empty: there are none.
std::string key_list(const Bindings& bindings, ActionId action, bool pad);

}  // namespace lanthorn::input
