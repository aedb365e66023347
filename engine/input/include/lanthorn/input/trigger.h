// What can be pressed: keys, mouse buttons, the wheel, gamepad buttons; and what they are called.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lanthorn::input {

// Something that can be pressed. A notch of the wheel is a press and a release at once; a trigger of the pad
// is pressed from its middle on.
struct Trigger {
    // What it is a part of; a wheel's notches and a pad's triggers count as buttons.
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

}  // namespace lanthorn::input
