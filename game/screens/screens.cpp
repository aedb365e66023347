#include "game/screens/screens.h"

namespace lanthorn::game {

namespace {

Change to(Screens state, Screen screen, Effect effect = Effect::none) {
    state.at = screen;
    return {state, effect};
}

Change load(Screens state, int level) {
    if (state.once) {
        return {state, Effect::refuse};
    }
    state.level = level;
    state.begun = true;
    state.stayed = false;
    return to(state, Screen::play, Effect::load);
}

Change aside(Screens state, Screen screen) {
    state.back = state.at;
    return to(state, screen);
}

// What was done in the level is lost: not without a question.
Change ask_restart(const Screens& state) {
    return state.once ? Change{state, Effect::refuse} : aside(state, Screen::restart);
}

Change on_restart(const Screens& state, const Event& event) {
    switch (event.what) {
        case Happening::reset:
            return load(state, state.level);
        case Happening::play:
            return to(state, Screen::play);
        case Happening::back:
            return to(state, state.back);
        default:
            return {state};
    }
}

Change on_title(const Screens& state, const Event& event) {
    switch (event.what) {
        case Happening::play:
            return state.begun ? to(state, Screen::play) : Change{state};
        case Happening::begin:
            return load(state, 0);
        case Happening::levels:
            return aside(state, Screen::levels);
        case Happening::options:
            return aside(state, Screen::options);
        case Happening::credits:
            return aside(state, Screen::credits);
        default:
            return {state};
    }
}

Change on_levels(const Screens& state, const Event& event) {
    const bool there = event.level >= 0 && event.level < state.levels;
    if (event.what == Happening::choose && there) {
        return load(state, event.level);
    }
    return event.what == Happening::back ? to(state, state.back) : Change{state};
}

Change on_play(const Screens& state, const Event& event) {
    switch (event.what) {
        case Happening::pause:
            return to(state, Screen::paused, Effect::keep);
        case Happening::reset:
            return ask_restart(state);
        case Happening::solved:
            if (!state.stayed) {
                Screens solved = state;
                solved.stayed = true;
                return to(solved, Screen::finished, Effect::keep);
            }
            return {state};
        default:
            return {state};
    }
}

Change on_paused(const Screens& state, const Event& event) {
    switch (event.what) {
        case Happening::play:
        case Happening::back:
            return to(state, Screen::play);
        case Happening::reset:
            return ask_restart(state);
        case Happening::levels:
            return aside(state, Screen::levels);
        case Happening::options:
            return aside(state, Screen::options);
        case Happening::title:
            return to(state, Screen::title, Effect::keep);
        default:
            return {state};
    }
}

Change on_finished(const Screens& state, const Event& event) {
    switch (event.what) {
        case Happening::next:
            if (state.level + 1 < state.levels) {
                return load(state, state.level + 1);
            }
            return state.unsolved ? load(state, *state.unsolved) : to(state, Screen::title);
        case Happening::play:
        case Happening::back:
            return to(state, Screen::play);
        case Happening::levels:
            return aside(state, Screen::levels);
        case Happening::credits:
            return aside(state, Screen::credits);
        case Happening::title:
            return to(state, Screen::title);
        default:
            return {state};
    }
}

}  // namespace

Change follow(const Screens& from, const Event& event) {
    if (event.what == Happening::quit) {
        return {from, Effect::quit};
    }
    switch (from.at) {
        case Screen::loading:
            break;
        case Screen::title:
            return on_title(from, event);
        case Screen::levels:
            return on_levels(from, event);
        case Screen::play:
            return on_play(from, event);
        case Screen::paused:
            return on_paused(from, event);
        case Screen::restart:
            return on_restart(from, event);
        case Screen::options:
            return event.what == Happening::controls ? to(from, Screen::controls)
                   : event.what == Happening::back   ? to(from, from.back)
                                                     : Change{from};
        case Screen::controls:
            return event.what == Happening::back ? to(from, Screen::options) : Change{from};
        case Screen::finished:
            return on_finished(from, event);
        case Screen::credits:
            return event.what == Happening::back ? to(from, from.back) : Change{from};
    }
    return {from};
}

}  // namespace lanthorn::game
