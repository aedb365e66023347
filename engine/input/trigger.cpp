#include "lanthorn/input/trigger.h"

#define GLFW_INCLUDE_NONE  // names of keys alone
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace lanthorn::input {

namespace {

using Device = Trigger::Device;

struct Named {
    const char* name;
    Trigger trigger;
};

constexpr Trigger key(int code) {
    return {Device::keyboard, code};
}
constexpr Trigger mouse(int code) {
    return {Device::mouse, code};
}
constexpr Trigger wheel(int code) {
    return {Device::wheel, code};
}
constexpr Trigger pad(int code) {
    return {Device::pad, code};
}

// Letters, digits, function keys and those of the number pad are named by rule.
constexpr Named kNames[] = {
    {"Space", key(GLFW_KEY_SPACE)},
    {"Apostrophe", key(GLFW_KEY_APOSTROPHE)},
    {"Comma", key(GLFW_KEY_COMMA)},
    {"Minus", key(GLFW_KEY_MINUS)},
    {"Period", key(GLFW_KEY_PERIOD)},
    {"Slash", key(GLFW_KEY_SLASH)},
    {"Semicolon", key(GLFW_KEY_SEMICOLON)},
    {"Equal", key(GLFW_KEY_EQUAL)},
    {"Left Bracket", key(GLFW_KEY_LEFT_BRACKET)},
    {"Backslash", key(GLFW_KEY_BACKSLASH)},
    {"Right Bracket", key(GLFW_KEY_RIGHT_BRACKET)},
    {"Grave Accent", key(GLFW_KEY_GRAVE_ACCENT)},
    {"Escape", key(GLFW_KEY_ESCAPE)},
    {"Enter", key(GLFW_KEY_ENTER)},
    {"Tab", key(GLFW_KEY_TAB)},
    {"Backspace", key(GLFW_KEY_BACKSPACE)},
    {"Insert", key(GLFW_KEY_INSERT)},
    {"Delete", key(GLFW_KEY_DELETE)},
    {"Right", key(GLFW_KEY_RIGHT)},
    {"Left", key(GLFW_KEY_LEFT)},
    {"Down", key(GLFW_KEY_DOWN)},
    {"Up", key(GLFW_KEY_UP)},
    {"Page Up", key(GLFW_KEY_PAGE_UP)},
    {"Page Down", key(GLFW_KEY_PAGE_DOWN)},
    {"Home", key(GLFW_KEY_HOME)},
    {"End", key(GLFW_KEY_END)},
    {"Left Shift", key(GLFW_KEY_LEFT_SHIFT)},
    {"Left Control", key(GLFW_KEY_LEFT_CONTROL)},
    {"Left Alt", key(GLFW_KEY_LEFT_ALT)},
    {"Right Shift", key(GLFW_KEY_RIGHT_SHIFT)},
    {"Right Control", key(GLFW_KEY_RIGHT_CONTROL)},
    {"Right Alt", key(GLFW_KEY_RIGHT_ALT)},
    {"Keypad Enter", key(GLFW_KEY_KP_ENTER)},
    {"Mouse Left", mouse(GLFW_MOUSE_BUTTON_LEFT)},
    {"Mouse Right", mouse(GLFW_MOUSE_BUTTON_RIGHT)},
    {"Mouse Middle", mouse(GLFW_MOUSE_BUTTON_MIDDLE)},
    {"Wheel Up", wheel(0)},
    {"Wheel Down", wheel(1)},
    {"Pad A", pad(GLFW_GAMEPAD_BUTTON_A)},
    {"Pad B", pad(GLFW_GAMEPAD_BUTTON_B)},
    {"Pad X", pad(GLFW_GAMEPAD_BUTTON_X)},
    {"Pad Y", pad(GLFW_GAMEPAD_BUTTON_Y)},
    {"Pad Left Bumper", pad(GLFW_GAMEPAD_BUTTON_LEFT_BUMPER)},
    {"Pad Right Bumper", pad(GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER)},
    {"Pad Back", pad(GLFW_GAMEPAD_BUTTON_BACK)},
    {"Pad Start", pad(GLFW_GAMEPAD_BUTTON_START)},
    {"Pad Guide", pad(GLFW_GAMEPAD_BUTTON_GUIDE)},
    {"Pad Left Stick", pad(GLFW_GAMEPAD_BUTTON_LEFT_THUMB)},
    {"Pad Right Stick", pad(GLFW_GAMEPAD_BUTTON_RIGHT_THUMB)},
    {"Pad Up", pad(GLFW_GAMEPAD_BUTTON_DPAD_UP)},
    {"Pad Right", pad(GLFW_GAMEPAD_BUTTON_DPAD_RIGHT)},
    {"Pad Down", pad(GLFW_GAMEPAD_BUTTON_DPAD_DOWN)},
    {"Pad Left", pad(GLFW_GAMEPAD_BUTTON_DPAD_LEFT)},
    {"Pad Left Trigger", pad(kLeftTrigger)},
    {"Pad Right Trigger", pad(kRightTrigger)},
};

// Names that end with a number: the trigger of the first one, and how many there are.
struct Row {
    const char* name;
    int first;
    Trigger trigger;
    int count;
};
constexpr Row kRows[] = {
    {"F", 1, key(GLFW_KEY_F1), 25},
    {"Keypad ", 0, key(GLFW_KEY_KP_0), 10},
    {"Mouse ", 4, mouse(GLFW_MOUSE_BUTTON_4), 5},
    {"Key ", 0, key(0), GLFW_KEY_LAST + 1},
};

bool same(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::optional<Trigger> in_row(const Row& row, std::string_view name) {
    const std::string_view beginning = row.name;
    if (name.size() <= beginning.size() || !same(name.substr(0, beginning.size()), beginning)) {
        return std::nullopt;
    }
    int number = 0;
    const char* const last = name.data() + name.size();
    const auto [end, error] = std::from_chars(name.data() + beginning.size(), last, number);
    if (error != std::errc() || end != last || number < row.first || number >= row.first + row.count) {
        return std::nullopt;
    }
    return Trigger{row.trigger.device, row.trigger.code + number - row.first};
}

}  // namespace

std::string name_of(Trigger trigger) {
    if (trigger.device == Device::keyboard && ((trigger.code >= GLFW_KEY_A && trigger.code <= GLFW_KEY_Z) ||
                                               (trigger.code >= GLFW_KEY_0 && trigger.code <= GLFW_KEY_9))) {
        return {static_cast<char>(trigger.code)};  // GLFW's numbers of these are ASCII's
    }
    for (const Named& named : kNames) {
        if (named.trigger == trigger) {
            return named.name;
        }
    }
    for (const Row& row : kRows) {
        const int place = trigger.code - row.trigger.code;
        if (trigger.device == row.trigger.device && place >= 0 && place < row.count) {
            return row.name + std::to_string(row.first + place);
        }
    }
    return "?";
}

std::optional<Trigger> find_trigger(std::string_view name) {
    if (name.size() == 1 && std::isalnum(static_cast<unsigned char>(name[0])) != 0) {
        return key(std::toupper(static_cast<unsigned char>(name[0])));
    }
    for (const Named& named : kNames) {
        if (same(name, named.name)) {
            return named.trigger;
        }
    }
    for (const Row& row : kRows) {
        if (const std::optional<Trigger> found = in_row(row, name)) {
            return found;
        }
    }
    return std::nullopt;
}

}  // namespace lanthorn::input
