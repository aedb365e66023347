#include "game/screens/model.h"

#include <algorithm>

namespace lanthorn::game::ui {

std::string Model::say_with_keys(std::string_view english) const {
    return fill_in(say(english), [&](std::string_view name) {
        const auto found = std::ranges::find(actions(), name, &input::Action::name);
        return found == actions().end() ? std::string()
                                        : keys[static_cast<std::size_t>(found - actions().begin())];
    });
}

}  // namespace lanthorn::game::ui
