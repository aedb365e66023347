// A gamepad in the menus: left stick and directional pad choose, A takes, B goes back.
#pragma once

#include <imgui.h>

#include "lanthorn/input/controls.h"

namespace lanthorn::game::ui {

// As Controls has it, or nothing where there is none. Call before ImGui::NewFrame(), which forgets it in the
// end.
void feed_gamepad(const std::optional<input::PadState>& pad, ImGuiIO& io);

}  // namespace lanthorn::game::ui
