// How lamplighter's screens look: quiet and warm, and legible over any picture.
#pragma once

#include <imgui.h>

#include "lanthorn/ui/theme.h"

namespace lanthorn::game::ui {

inline constexpr const char* kName = "lamplighter";

const lanthorn::ui::Theme& theme();

// Its colours; `alpha` 0..1 on top of their own.
ImU32 lamplight(float alpha = 1);  // what is chosen, what glows
ImU32 parchment(float alpha = 1);  // words
ImU32 night(float alpha = 1);      // what lies behind words

}  // namespace lanthorn::game::ui
