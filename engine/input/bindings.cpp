#include "lanthorn/input/bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"

namespace lanthorn::input {

namespace {

constexpr const char* kTable = "actions";  // where a table of a program itself is wrong

std::vector<Trigger> usual_triggers(const Action& action) {
    std::vector<Trigger> triggers;
    std::string_view names = action.triggers;
    while (!names.empty()) {
        const std::size_t end = std::min(names.find(", "), names.size());
        const std::optional<Trigger> found = find_trigger(names.substr(0, end));
        if (!found) {
            throw InputError(
                kTable, action.name,
                fmt::format("found trigger \"{}\", expected names as \"E, Pad A\"", names.substr(0, end)));
        }
        triggers.push_back(*found);
        names.remove_prefix(std::min(end + 2, names.size()));
    }
    return triggers;
}

bool contains(std::span<const Trigger> triggers, Trigger trigger) {
    return std::ranges::find(triggers, trigger) != triggers.end();
}

std::size_t find_row(std::span<const Action> actions, std::string_view name, std::string_view source) {
    const auto found =
        std::ranges::find_if(actions, [&](const Action& action) { return name == action.name; });
    if (found == actions.end()) {
        std::string known;
        for (const Action& action : actions) {
            known += (known.empty() ? "" : ", ") + std::string(action.name);
        }
        throw InputError(source, name, "is no action, expected one of " + known);
    }
    return static_cast<std::size_t>(found - actions.begin());
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

Bindings::Bindings(std::span<const Action> actions) : actions_(actions) {
    if (actions.size() > kMostActions) {
        throw InputError(kTable, "",
                         fmt::format("found {} actions, expected at most {}", actions.size(), kMostActions));
    }
    for (const Action& action : actions) {
        std::vector<Trigger> triggers = usual_triggers(action);
        for (std::size_t before = 0; before < triggers_.size(); ++before) {
            if (std::string_view(actions[before].name) == action.name) {
                throw InputError(kTable, action.name, "found twice, expected a name of its own");
            }
            for (const Trigger trigger : triggers) {
                if (contains(triggers_[before], trigger)) {
                    throw InputError(kTable, action.name,
                                     fmt::format("found {}, which \"{}\" has, expected triggers of its own",
                                                 name_of(trigger), actions[before].name));
                }
            }
        }
        triggers_.push_back(std::move(triggers));
    }
    if (const Action* menu = shut_menu()) {
        throw InputError(kTable, menu->name, "found no trigger, expected at least one");
    }
}

const Action* Bindings::shut_menu() const {
    for (std::size_t row = 0; row < actions_.size(); ++row) {
        if (actions_[row].kind == Kind::menu && triggers_[row].empty()) {
            return &actions_[row];
        }
    }
    return nullptr;
}

bool Bindings::binds(Trigger trigger, ActionId action) const {
    return contains(of(action), trigger);
}

bool Bindings::bind(ActionId action, std::vector<Trigger> triggers) {
    Bindings changed = *this;
    for (std::vector<Trigger>& others : changed.triggers_) {
        std::erase_if(others, [&](Trigger t) { return contains(triggers, t); });
    }
    changed.triggers_[action.row()] = std::move(triggers);
    if (changed.shut_menu() != nullptr) {
        return false;
    }
    *this = std::move(changed);
    return true;
}

std::string Bindings::to_json() const {
    nlohmann::ordered_json root = nlohmann::ordered_json::object();
    for (std::size_t row = 0; row < actions_.size(); ++row) {
        nlohmann::ordered_json& list = root[actions_[row].name] = nlohmann::ordered_json::array();
        for (const Trigger trigger : triggers_[row]) {
            list.push_back(name_of(trigger));
        }
    }
    return root.dump(4) + '\n';
}

Bindings read_bindings(std::span<const Action> actions, std::string_view json, std::string_view source) {
    const nlohmann::json root = parse_json_object(json, source, "actions");
    Bindings bindings(actions);
    std::vector<Trigger> given;  // by the file
    std::vector<bool> named(actions.size());
    for (const auto& item : root.items()) {
        const std::size_t row = find_row(actions, item.key(), source);
        std::vector<Trigger>& own = bindings.triggers_[row];
        own = triggers_from(item.value(), source, item.key());
        given.insert(given.end(), own.begin(), own.end());
        named[row] = true;
    }
    // An action that the file does not name, being newer than it, say, has what the file leaves of its own.
    for (std::size_t row = 0; row < named.size(); ++row) {
        if (!named[row]) {
            std::erase_if(bindings.triggers_[row], [&](Trigger t) { return contains(given, t); });
        }
    }
    if (const Action* menu = bindings.shut_menu()) {
        throw InputError(source, menu->name, "found no key, expected at least one");
    }
    return bindings;
}

}  // namespace lanthorn::input
