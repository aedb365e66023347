// Shapes that stand for colours.
#pragma once

#include <imgui.h>

#include "game/rules/components.h"

namespace lanthorn::game::ui {

// Around `centre`, `radius` pixels large, on a dark disc. `charge`, 0..1: how far the ring around it closes;
// at 1 the shape is filled.
void draw_symbol(ImDrawList& draw, Symbol symbol, const ImVec2& centre, float radius, float charge);

// The ring alone, around what is seen there.
void draw_charge(ImDrawList& draw, const ImVec2& centre, float radius, float charge);

}  // namespace lanthorn::game::ui
