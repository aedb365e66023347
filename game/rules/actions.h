// What the player can do: the one table from which keys, recorded inputs, pages, help and the docs come.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "game/rules/components.h"
#include "game/rules/player_input.h"
#include "lanthorn/input/controls.h"

namespace lanthorn::game {

enum class Action : std::uint8_t {
    forward,
    back,
    left,
    right,
    use,
    light,
    carry,
    dim_up,
    dim_down,
    colour,
    view,
    hint,
    reset,
    picture,
    menu,
};
inline constexpr std::size_t kActions = 15;

// All of them, in the order of Action; Action::mark is the Button that the steps see.
const std::array<input::Action, kActions>& actions();

// What a tour's leg presses: a bit of PlayerInput::held. None: 0.
std::uint16_t button_of(Deed deed);

// As the game has them unless told otherwise.
input::Bindings usual_bindings();
// See input::read_bindings.
input::Bindings read_bindings(std::string_view json, std::string_view source);

// What a step sees at the devices, as it is recorded.
PlayerInput player_input(const input::Step& step);

}  // namespace lanthorn::game
