#include "game/presentation/key_names.h"

namespace lanthorn::game {

namespace {

std::string key_name(const Bindings& bindings, Action action, bool pad) {
    std::string name;
    for (const Trigger trigger : bindings.of(action)) {
        const bool fits = (trigger.device == Trigger::Device::pad) == pad;
        if (name.empty() || fits) {
            name = name_of(trigger);
        }
        if (fits) {
            break;
        }
    }
    return name.starts_with("Pad ") ? name.substr(4) : name == "Escape" ? "Esc" : name;
}

}  // namespace

std::array<std::string, kActions> key_names(const Bindings& bindings, bool pad) {
    std::array<std::string, kActions> names;
    for (const ActionInfo& info : actions()) {
        names[static_cast<std::size_t>(info.action)] = key_name(bindings, info.action, pad);
    }
    return names;
}

}  // namespace lanthorn::game
