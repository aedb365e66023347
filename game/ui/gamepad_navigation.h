// A gamepad in the menus: left stick and directional pad choose, A takes, B goes back.
#pragma once

#include <imgui.h>

struct GLFWgamepadstate;

namespace lanthorn::game::ui {

// As GLFW maps gamepads (Xbox layout). Call before ImGui::NewFrame(), which forgets it in the end.
void feed_gamepad(const GLFWgamepadstate& pad, ImGuiIO& io);

}  // namespace lanthorn::game::ui
