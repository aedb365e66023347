// What to press for each action, in words that fit on a screen.
#pragma once

#include <array>
#include <string>

#include "game/presentation/bindings.h"

namespace lanthorn::game {

// By Action: on the gamepad (`pad`), or on keyboard and mouse; where nothing is bound there, on the other
// one. Empty: nothing is.
std::array<std::string, kActions> key_names(const Bindings& bindings, bool pad);

}  // namespace lanthorn::game
