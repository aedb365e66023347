#include <algorithm>
#include <string>
#include <vector>

#include "game/screens/pages.h"

namespace lanthorn::game::ui {

namespace {

bool of_pad(Trigger trigger) {
    return trigger.device == Trigger::Device::pad;
}

std::string names_of(const Bindings& bindings, Action action) {
    std::string names;
    for (const Trigger trigger : bindings.of(action)) {
        names += (names.empty() ? "" : ", ") + name_of(trigger);
    }
    return names;
}

// The key takes the place of the action's keys, a gamepad's button that of its buttons.
void bind(Bindings& bindings, Action action, Trigger trigger) {
    std::vector<Trigger> triggers(bindings.of(action).begin(), bindings.of(action).end());
    std::erase_if(triggers, [&](Trigger other) { return of_pad(other) == of_pad(trigger); });
    triggers.push_back(trigger);
    bindings.bind(action, triggers);
}

void draw_question(const Model& model, Choices& choices) {
    const Action action = *choices.asked;
    ImGui::TextUnformatted(model.say(actions()[static_cast<std::size_t>(action)].words).c_str());
    ImGui::TextDisabled("%s",
                        model.say_with_keys("Press a key or a button for it. {menu} leaves it.").c_str());
    if (!model.pressed.empty()) {
        const Trigger trigger = model.pressed.front();
        if (action == Action::menu || !choices.bindings.binds(trigger, Action::menu)) {
            bind(choices.bindings, action, trigger);
        }
        choices.asked.reset();
    }
}

}  // namespace

std::optional<Event> draw_controls(const Model& model, Choices& choices) {
    std::optional<Event> event;
    draw_shade(model.page, 0.72f, 0.92f, lanthorn::ui::kColumnUnits);
    begin_column(model.page, "controls", model.say("Keys and buttons"), "");
    if (choices.asked) {
        draw_question(model, choices);
    } else {
        for (std::size_t i = 0; i < actions().size(); ++i) {
            const auto action = static_cast<Action>(i);
            const std::string names = names_of(choices.bindings, action);
            row(
                model.page, model.say(actions()[i].words).c_str(),
                names.empty() ? model.say("nothing") : names, [&](int) { choices.asked = action; }, i == 0);
        }
        row(model.page, model.say("all as usual").c_str(), model.say("take back"),
            [&](int) { choices.bindings = usual_bindings(); });
        if (entry(model.page, model.say("Back").c_str()) || wants_back(model.page)) {
            event = {Happening::back};
        }
    }
    end_column(model.page);
    return event;
}

}  // namespace lanthorn::game::ui
