#include "game/presentation/bindings.h"

#define GLFW_INCLUDE_NONE  // names of keys alone
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <nlohmann/json.hpp>

#include "engine/core/json_object.h"
#include "lanthorn/core/error.h"

namespace lanthorn::game {

namespace {

using Device = Trigger::Device;

constexpr std::array<ActionInfo, kActions> kInfos = {{
    {Action::forward, "forward", "walk forward"},
    {Action::back, "back", "walk back"},
    {Action::left, "left", "walk to the left"},
    {Action::right, "right", "walk to the right"},
    {Action::use, "use", "use what is at hand"},
    {Action::light, "light", "light the lantern, put it out"},
    {Action::carry, "carry", "pick up, put down"},
    {Action::dim_up, "dim_up", "brighter"},
    {Action::dim_down, "dim_down", "darker"},
    {Action::colour, "colour", "another colour"},
    {Action::view, "view", "look from behind, or with her eyes"},
    {Action::hint, "hint", "a hint"},
    {Action::reset, "reset", "begin the level anew"},
    {Action::menu, "menu", "menu"},
}};

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

const nlohmann::json& checked_list(const nlohmann::json& list, std::string_view source,
                                   const std::string& place) {
    if (!list.is_array()) {
        throw InputError(source, place,
                         fmt::format("found {}, expected a list of names of keys", list.type_name()));
    }
    return list;
}

std::vector<Trigger> triggers_from(const nlohmann::json& list, std::string_view source,
                                   const std::string& place) {
    std::vector<Trigger> triggers;
    for (const nlohmann::json& name : checked_list(list, source, place)) {
        const std::optional<Trigger> found =
            name.is_string() ? find_trigger(name.get<std::string>()) : std::nullopt;
        if (!found) {
            throw InputError(source, place,
                             fmt::format("found {}, expected a key, a mouse button or a gamepad button as "
                                         "\"E\", \"Mouse Left\" or \"Pad A\"",
                                         name.dump()));
        }
        triggers.push_back(*found);
    }
    return triggers;
}

}  // namespace

std::span<const ActionInfo, kActions> actions() {
    return kInfos;
}

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

Bindings::Bindings() {
    const auto set = [&](Action action, std::vector<Trigger> triggers) {
        triggers_[static_cast<std::size_t>(action)] = std::move(triggers);
    };
    set(Action::forward, {key(GLFW_KEY_W)});
    set(Action::back, {key(GLFW_KEY_S)});
    set(Action::left, {key(GLFW_KEY_A)});
    set(Action::right, {key(GLFW_KEY_D)});
    set(Action::use, {key(GLFW_KEY_E), pad(GLFW_GAMEPAD_BUTTON_A)});
    set(Action::light, {key(GLFW_KEY_F), pad(GLFW_GAMEPAD_BUTTON_X)});
    set(Action::carry, {key(GLFW_KEY_G), pad(GLFW_GAMEPAD_BUTTON_B)});
    set(Action::dim_up, {key(GLFW_KEY_R), wheel(0), pad(GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER)});
    set(Action::dim_down, {key(GLFW_KEY_T), wheel(1), pad(GLFW_GAMEPAD_BUTTON_LEFT_BUMPER)});
    set(Action::colour, {key(GLFW_KEY_C), pad(GLFW_GAMEPAD_BUTTON_Y)});
    set(Action::view, {key(GLFW_KEY_V), pad(GLFW_GAMEPAD_BUTTON_RIGHT_THUMB)});
    set(Action::hint, {key(GLFW_KEY_H), pad(GLFW_GAMEPAD_BUTTON_DPAD_UP)});
    set(Action::reset, {key(GLFW_KEY_BACKSPACE), pad(GLFW_GAMEPAD_BUTTON_BACK)});
    set(Action::menu, {key(GLFW_KEY_ESCAPE), pad(GLFW_GAMEPAD_BUTTON_START)});
}

bool Bindings::binds(Trigger trigger, Action action) const {
    return std::ranges::find(of(action), trigger) != of(action).end();
}

bool Bindings::bind(Action action, std::vector<Trigger> triggers) {
    Bindings changed = *this;
    for (std::vector<Trigger>& others : changed.triggers_) {
        std::erase_if(others, [&](Trigger t) { return std::ranges::find(triggers, t) != triggers.end(); });
    }
    changed.triggers_[static_cast<std::size_t>(action)] = std::move(triggers);
    if (changed.of(Action::menu).empty()) {
        return false;
    }
    *this = std::move(changed);
    return true;
}

std::string Bindings::to_json() const {
    nlohmann::ordered_json root;
    for (const ActionInfo& info : actions()) {
        nlohmann::ordered_json& list = root[info.name] = nlohmann::ordered_json::array();
        for (const Trigger trigger : of(info.action)) {
            list.push_back(name_of(trigger));
        }
    }
    return root.dump(4) + '\n';
}

Bindings read_bindings(std::string_view json, std::string_view source) {
    const nlohmann::json root = parse_json_object(json, source, "actions");
    Bindings bindings;
    std::vector<Trigger> given;  // by the file
    std::array<bool, kActions> named{};
    for (const auto& item : root.items()) {
        const std::string& name = item.key();
        const auto found =
            std::ranges::find_if(kInfos, [&](const ActionInfo& info) { return name == info.name; });
        if (found == kInfos.end()) {
            std::string known;
            for (const ActionInfo& info : kInfos) {
                known += (known.empty() ? "" : ", ") + std::string(info.name);
            }
            throw InputError(source, name, "is no action, expected one of " + known);
        }
        std::vector<Trigger>& own = bindings.triggers_[static_cast<std::size_t>(found->action)];
        own = triggers_from(item.value(), source, name);
        given.insert(given.end(), own.begin(), own.end());
        named[static_cast<std::size_t>(found->action)] = true;
    }
    // An action that the file does not name, being newer than it, say, has what the file leaves of its own.
    for (std::size_t i = 0; i < named.size(); ++i) {
        if (!named[i]) {
            std::erase_if(bindings.triggers_[i],
                          [&](Trigger t) { return std::ranges::find(given, t) != given.end(); });
        }
    }
    if (bindings.of(Action::menu).empty()) {
        throw InputError(source, "menu", "found no key, expected at least one");
    }
    return bindings;
}

}  // namespace lanthorn::game
