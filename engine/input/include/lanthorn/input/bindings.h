// Which keys, mouse buttons and gamepad buttons mean which action: data, so that people can choose.
//
//   {"use": ["E", "Pad A"], "brighter": ["R", "Wheel Up"], ...}
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/input/action.h"
#include "lanthorn/input/trigger.h"

namespace lanthorn::input {

class Bindings {
  public:
    // As the table has them. It must outlive this. Throws InputError, with the action's name, for a trigger
    // that is none, a name twice, a trigger that means two things, a menu without any, and for more than
    // kMostActions rows.
    explicit Bindings(std::span<const Action> actions);

    std::span<const Action> actions() const { return actions_; }  // the table that this was made with
    // What the action is bound to, in the order of its binding; may be empty.
    std::span<const Trigger> of(ActionId action) const { return triggers_[action.row()]; }
    bool binds(Trigger trigger, ActionId action) const;  // `trigger` is one of `action`'s
    // In place of all that the action had. Whatever else used one of them loses it, but for menus: without a
    // way there nothing could be bound anew. False, and nothing changes, where a menu would be left without.
    bool bind(ActionId action, std::vector<Trigger> triggers);

    // As read_bindings takes them; indented JSON with a trailing newline.
    std::string to_json() const;

    // Of the same table.
    bool operator==(const Bindings& other) const { return triggers_ == other.triggers_; }

  private:
    friend Bindings read_bindings(std::span<const Action> actions, std::string_view json,
                                  std::string_view source);
    // The first menu without a trigger; null: there is none.
    const Action* shut_menu() const;

    std::span<const Action> actions_;
    std::vector<std::vector<Trigger>> triggers_;  // by row
};

// What the text does not name stays as the table has it. `source`: for messages. Throws InputError, with the
// place, for what is no JSON of this kind, for unknown actions and triggers, and for a menu that nothing
// opens.
Bindings read_bindings(std::span<const Action> actions, std::string_view json, std::string_view source);

// What to press for an action, in words that fit on a screen: "Esc", "E", "A": on the gamepad (`pad`), or on
// keyboard and mouse; where nothing is bound there, on the other one. Empty: nothing is.
std::string key_name(const Bindings& bindings, ActionId action, bool pad);

// All of one device, "R, Wheel Up", those of the gamepad without "Pad". Empty: there are none.
std::string key_list(const Bindings& bindings, ActionId action, bool pad);

}  // namespace lanthorn::input
