#include "game/screens/pages.h"

#include <algorithm>

#include "game/level/story.h"
#include "game/screens/tower.h"

namespace lanthorn::game::ui {

namespace {

std::string title_of_level(const Model& model) {
    const auto level = static_cast<std::size_t>(model.screens.level);
    return level < model.levels.size() ? model.levels[level].title : "";
}

bool entry(const Model& model, const char* english, bool first = false) {
    return lanthorn::ui::entry(model.page, model.say(english).c_str(), first);
}

}  // namespace

void draw_loading(const Model& model) {
    const bool begins = !model.screens.begun;
    begin_column(model.page, "loading", begins ? kName : title_of_level(model),
                 begins ? model.say("Carry the light to where no lamp can shine.") : "");
    ImGui::TextDisabled("%s", model.say("Lighting the lamps ...").c_str());
    end_column(model.page);
}

std::optional<Event> draw_title(const Model& model) {
    std::optional<Event> event;
    draw_shade(model.page, 0.62f, 0.88f);
    draw_tower(model);
    begin_column(model.page, "title", kName, model.say("Carry the light to where no lamp can shine."));
    if (model.screens.begun) {
        if (entry(model, "Continue", true)) {
            event = {Happening::play};
        }
    } else if (entry(model, "Play", true)) {
        event = {Happening::begin};
    }
    if (entry(model, "Levels")) {
        event = {Happening::levels};
    }
    if (entry(model, "Options")) {
        event = {Happening::options};
    }
    if (entry(model, "Credits")) {
        event = {Happening::credits};
    }
    if (entry(model, "Quit")) {
        event = {Happening::quit};
    }
    end_column(model.page);
    return event;
}

std::optional<Event> draw_paused(const Model& model) {
    std::optional<Event> event;
    draw_shade(model.page, 0.62f, 0.88f);
    begin_column(model.page, "paused", title_of_level(model), model.say("Paused"));
    if (entry(model, "Resume", true)) {
        event = {Happening::play};
    }
    if (entry(model, "Begin the level again")) {
        event = {Happening::reset};
    }
    if (entry(model, "Levels")) {
        event = {Happening::levels};
    }
    if (entry(model, "Options")) {
        event = {Happening::options};
    }
    if (entry(model, "Title")) {
        event = {Happening::title};
    }
    if (entry(model, "Quit")) {
        event = {Happening::quit};
    }
    end_column(model.page);
    return wants_back(model.page) ? Event{Happening::back} : event;
}

std::optional<Event> draw_restart(const Model& model) {
    std::optional<Event> event;
    draw_shade(model.page, 0.62f, 0.88f);
    begin_column(model.page, "restart", model.say("Begin the level again?"),
                 model.say("What was done in it is lost."));
    if (entry(model, "No, go on", true)) {
        event = {Happening::back};
    }
    if (entry(model, "Begin again")) {
        event = {Happening::reset};
    }
    end_column(model.page);
    return wants_back(model.page) ? Event{Happening::back} : event;
}

std::optional<Event> draw_finished(const Model& model) {
    std::optional<Event> event;
    const bool last = model.screens.level + 1 >= model.screens.levels;
    const bool all = last && std::ranges::all_of(model.levels, &LevelCard::solved);
    draw_shade(model.page, 0.5f, 0.8f);
    if (all) {
        draw_tower(model);
    }
    begin_column(model.page, "finished", all ? model.say("All is lit") : title_of_level(model),
                 model.say(all ? kEnding : "The light has found its way."));
    if (entry(model, all ? "To the title" : "Next level", true)) {
        event = {Happening::next};
    }
    if (all && entry(model, "Credits")) {
        event = {Happening::credits};
    }
    if (entry(model, "Stay a while")) {
        event = {Happening::play};
    }
    if (entry(model, "Levels")) {
        event = {Happening::levels};
    }
    if (entry(model, "Quit")) {
        event = {Happening::quit};
    }
    end_column(model.page);
    return wants_back(model.page) ? Event{Happening::back} : event;
}

std::optional<Event> draw_screen(const Model& model, Choices& choices) {
    std::optional<Event> event;
    switch (model.screens.at) {
        case Screen::loading:
            draw_loading(model);
            break;
        case Screen::title:
            event = draw_title(model);
            break;
        case Screen::levels:
            event = draw_levels(model);
            break;
        case Screen::play:
            draw_hud(model);
            break;
        case Screen::paused:
            event = draw_paused(model);
            break;
        case Screen::restart:
            event = draw_restart(model);
            break;
        case Screen::options:
            event = draw_options(model, choices.preferences);
            break;
        case Screen::controls:
            event = draw_controls(model, choices);
            break;
        case Screen::finished:
            event = draw_finished(model);
            break;
        case Screen::credits:
            event = draw_credits(model);
            break;
    }
    if (model.screens.at == Screen::play) {
        draw_captions(model);
    }
    draw_notices(model);
    return event;
}

}  // namespace lanthorn::game::ui
