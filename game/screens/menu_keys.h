// What the player presses, as keys of the screens.
#pragma once

#include <vector>

#include "lanthorn/input/bindings.h"

namespace lanthorn::game::ui {

// The keys among what went down, by GLFW's numbers. The menu's keys and buttons come as Escape, but for those
// that choose on the screens. An ImGui context must be current.
std::vector<int> menu_keys(const std::vector<input::Trigger>& pressed, const input::Bindings& bindings);

}  // namespace lanthorn::game::ui
