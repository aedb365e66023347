// Fonts and sizes that follow the window.
#pragma once

#include <imgui.h>

#include <filesystem>
#include <string_view>

#include "lanthorn/core/math.h"

namespace lanthorn::ui {

// At 1280x720 a unit is a pixel; 0.6..8. Small windows keep letters of a legible size. `text_size`: what the
// user asked for, 1 is usual.
float unit_of(ivec2 window, double text_size);

// The font file `name`: in fonts/ of the installation, else in the folder `package` below
// /usr/share/fonts/opentype. Empty: nowhere.
std::filesystem::path font_file(std::string_view name, std::string_view package);

// Adds a font, `height` pixels high, to the current ImGui context's atlas. An empty `file` gives ImGui's own
// bitmap. `letters`: pairs of first and last, ended by 0; must outlive the atlas.
ImFont* add_font(const std::filesystem::path& file, float height, const ImWchar* letters);

}  // namespace lanthorn::ui
