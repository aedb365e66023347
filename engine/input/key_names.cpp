#include "lanthorn/input/bindings.h"

namespace lanthorn::input {

namespace {

bool of_pad(Trigger trigger) {
    return trigger.device == Trigger::Device::pad;
}

std::string short_name(Trigger trigger) {
    const std::string name = name_of(trigger);
    return name.starts_with("Pad ") ? name.substr(4) : name == "Escape" ? "Esc" : name;
}

}  // namespace

std::string key_name(const Bindings& bindings, ActionId action, bool pad) {
    for (const Trigger trigger : bindings.of(action)) {
        if (of_pad(trigger) == pad) {
            return short_name(trigger);
        }
    }
    return bindings.of(action).empty() ? "" : short_name(bindings.of(action).front());
}

std::string key_list(const Bindings& bindings, ActionId action, bool pad) {
    std::string names;
    for (const Trigger trigger : bindings.of(action)) {
        if (of_pad(trigger) == pad) {
            names += (names.empty() ? "" : ", ") + short_name(trigger);
        }
    }
    return names;
}

}  // namespace lanthorn::input
