#include "game/rules/actions.h"

#include <algorithm>

namespace lanthorn::game {

namespace {

using input::Kind;

struct Row {
    Action action;
    input::Action input;
    std::uint16_t button = 0;  // that the steps see
    Deed deed = Deed::none;    // of a tour, which presses it
};

constexpr std::array<Row, kActions> kRows = {{
    {Action::forward, {"forward", "walk forward", "W", Kind::held}},
    {Action::back, {"back", "walk back", "S", Kind::held}},
    {Action::left, {"left", "walk to the left", "A", Kind::held}},
    {Action::right, {"right", "walk to the right", "D", Kind::held}},
    {Action::use, {"use", "use what is at hand", "E, Pad A"}, kUse, Deed::use},
    {Action::light, {"light", "light the lantern, put it out", "F, Pad X"}, kLight, Deed::light},
    {Action::carry, {"carry", "pick up, put down", "G, Pad B"}, kCarry, Deed::carry},
    {Action::dim_up, {"dim_up", "brighter", "R, Wheel Up, Pad Right Bumper"}, kDimUp, Deed::brighter},
    {Action::dim_down, {"dim_down", "darker", "T, Wheel Down, Pad Left Bumper"}, kDimDown, Deed::darker},
    {Action::colour, {"colour", "another colour", "C, Pad Y"}, kColour, Deed::colour},
    {Action::view, {"view", "look from behind, or with her eyes", "V, Pad Right Stick"}, kView},
    {Action::hint, {"hint", "a hint", "H, Pad Up"}, kHint},
    {Action::reset, {"reset", "restart the level", "Backspace, Pad Back"}, kReset},
    {Action::picture, {"picture", "keep a picture of the window", "F12", Kind::always}},
    {Action::menu, {"menu", "menu", "Escape, Pad Start", Kind::menu}},
}};

constexpr bool in_order() {
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        if (kRows[i].action != static_cast<Action>(i)) {
            return false;
        }
    }
    return true;
}
static_assert(in_order(), "rows follow Action");

constexpr std::array<input::Action, kActions> kTable = [] {
    std::array<input::Action, kActions> table{};
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        table[i] = kRows[i].input;
        table[i].mark = kRows[i].button;
    }
    return table;
}();

}  // namespace

const std::array<input::Action, kActions>& actions() {
    return kTable;
}

std::uint16_t button_of(Deed deed) {
    const auto row = std::ranges::find(kRows, deed, &Row::deed);
    return deed == Deed::none || row == kRows.end() ? std::uint16_t{0} : row->button;
}

input::Bindings usual_bindings() {
    return input::Bindings(actions());
}

input::Bindings read_bindings(std::string_view json, std::string_view source) {
    return input::read_bindings(actions(), json, source);
}

PlayerInput player_input(const input::Step& step) {
    const auto on = [&](Action action) { return step.is_down(action) ? 1.0 : 0.0; };
    PlayerInput input;
    input.forward = axis(on(Action::forward) - on(Action::back) + step.forward);
    input.right = axis(on(Action::right) - on(Action::left) + step.right);
    input.yaw = step.yaw;
    input.pitch = step.pitch;
    input.held = static_cast<std::uint16_t>(step.marks);
    return input;
}

}  // namespace lanthorn::game
