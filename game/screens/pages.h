// The screens over the game. Each draws itself and returns what the player did there.
#pragma once

#include <optional>

#include "game/screens/model.h"

namespace lanthorn::game::ui {

// While a level is on its way. Nothing can be done there.
void draw_loading(const Model& model);
std::optional<Event> draw_title(const Model& model);
std::optional<Event> draw_levels(const Model& model);
std::optional<Event> draw_paused(const Model& model);
std::optional<Event> draw_restart(const Model& model);
std::optional<Event> draw_finished(const Model& model);
// Who and what made it.
std::optional<Event> draw_credits(const Model& model);
// These change the choices as the player does.
std::optional<Event> draw_options(const Model& model, Preferences& preferences);
std::optional<Event> draw_controls(const Model& model, Choices& choices);

// The words on the picture while playing, and the lines to be read on any screen.
void draw_hud(const Model& model);
void draw_notices(const Model& model);
// What is heard, at the upper left.
void draw_captions(const Model& model);

// The page of the screen, and the words over it.
std::optional<Event> draw_screen(const Model& model, Choices& choices);

}  // namespace lanthorn::game::ui
