// Which keys, mouse buttons and gamepad buttons mean what to the player: data, so that she can choose.
//
//   {"use": ["E", "Pad A"], "dim_up": ["R", "Wheel Up"], ...}
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
    menu,
};
inline constexpr std::size_t kActions = 14;

struct ActionInfo {
    Action action;
    const char* name;   // in files
    const char* words;  // for people
};
// All of them, in the order of Action.
std::span<const ActionInfo, kActions> actions();

// Something that can be pressed. A notch of the wheel is a press and a release at once; a trigger of the pad
// is pressed from its middle on.
struct Trigger {
    enum class Device : std::uint8_t { keyboard, mouse, wheel, pad };
    Device device = Device::keyboard;
    // keyboard, mouse and pad: as GLFW numbers them; wheel: 0 up, 1 down; pad: kLeftTrigger and kRightTrigger
    // besides.
    int code = 0;

    bool operator==(const Trigger&) const = default;
};
inline constexpr int kLeftTrigger = 100, kRightTrigger = 101;

// "E", "Left Shift", "Mouse Left", "Wheel Up", "Pad A"; a key without a name of its own is "Key 96".
std::string name_of(Trigger trigger);
// Upper and lower case are the same. Nothing if there is none of that name.
std::optional<Trigger> find_trigger(std::string_view name);

class Bindings {
  public:
    // As the game has them unless told otherwise.
    Bindings();

    std::span<const Trigger> of(Action action) const { return triggers_[static_cast<std::size_t>(action)]; }
    bool binds(Trigger trigger, Action action) const;
    // In place of all that the action had. Whatever else used one of them loses it, but for the menu: without
    // a way there nothing could be bound anew. False, and nothing changes, where the menu would be left
    // without.
    bool bind(Action action, std::vector<Trigger> triggers);

    // As read_bindings takes them; indented JSON with a trailing newline.
    std::string to_json() const;

    bool operator==(const Bindings&) const = default;

  private:
    friend Bindings read_bindings(std::string_view json, std::string_view source);
    std::array<std::vector<Trigger>, kActions> triggers_;
};

// What the text does not name stays at its default. `source`: for messages. Throws InputError, with the
// place, for what is no JSON of this kind, for unknown actions and triggers, and for a menu that nothing
// opens.
Bindings read_bindings(std::string_view json, std::string_view source);

}  // namespace lanthorn::game
