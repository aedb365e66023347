// A gamepad in the menus: left stick and directional pad choose, A takes, B goes back.
#pragma once

#include <imgui.h>

#include <bitset>

namespace lanthorn::ui {

// `buttons`: those that are down, by GLFW's numbers; `right`, `down`: the left stick's tilt, -1..1. Call
// before ImGui::NewFrame(), which forgets it in the end.
void feed_gamepad(const std::bitset<15>& buttons, double right, double down, ImGuiIO& io);

}  // namespace lanthorn::ui
