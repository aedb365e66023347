// How the editor looks: DejaVu at a size that the user chooses, plain colours, no rounding, no shadows.
#pragma once

#include <imgui.h>

#include <bit>
#include <cstdint>

#include "lanthorn/core/math.h"

namespace lanthorn::edit_window {

// sRGB, as ImGui has colours.
namespace colour {
inline constexpr ImU32 panel = IM_COL32(0x26, 0x26, 0x26, 255);
inline constexpr ImU32 bar = IM_COL32(0x1d, 0x1d, 0x1d, 255);
inline constexpr ImU32 surround = IM_COL32(0x77, 0x77, 0x77, 255);  // mid grey does not bias the eye
inline constexpr ImU32 words = IM_COL32(0xe4, 0xe4, 0xe4, 255);
inline constexpr ImU32 faint = IM_COL32(0xa0, 0xa0, 0xa0, 255);
inline constexpr ImU32 chosen = IM_COL32(0xff, 0xb0, 0x40, 255);
inline constexpr ImU32 chosen_row = IM_COL32(0x2f, 0x50, 0x70, 255);
inline constexpr ImU32 warning = IM_COL32(0xff, 0x9c, 0x3a, 255);
inline constexpr ImU32 good = IM_COL32(0x6c, 0xd0, 0x7c, 255);
inline constexpr ImU32 bad = IM_COL32(0xff, 0x6b, 0x5e, 255);
inline constexpr ImU32 x_axis = IM_COL32(0xf2, 0x4d, 0x4d, 255);
inline constexpr ImU32 y_axis = IM_COL32(0x6b, 0xc9, 0x3f, 255);
inline constexpr ImU32 z_axis = IM_COL32(0x4f, 0x8e, 0xf7, 255);
}  // namespace colour

inline ImVec2 im(const vec2& v) {
    return {v.x, v.y};
}

// A texture of OpenGL as ImGui takes one.
inline ImTextureID image_of(unsigned texture) {
    return std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}

// The fonts of one scale.
struct EditorFonts {
    ImFont* text = nullptr;
    ImFont* numbers = nullptr;  // letters of one width
};

// Fonts into the current ImGui context's atlas, in the place of those there are, and style for `unit` (1:
// text of 13 pixels). Then ui::Overlay::renew_fonts(). Where DejaVu is missing ImGui's own bitmap takes its
// place.
EditorFonts apply_editor_style(float unit);

}  // namespace lanthorn::edit_window
