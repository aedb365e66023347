// Which screen the player sees, and what leads to another: a function of what is there and what happens,
// without window and game.
#pragma once

#include <optional>

namespace lanthorn::game {

enum class Screen { loading, title, levels, play, paused, restart, options, controls, finished, credits };

// What there is. Behind every screen a level runs: the one that "continue" goes on with.
struct Screens {
    Screen at = Screen::title;
    Screen back = Screen::title;  // where levels, options, credits and the question of a restart lead back to
    int level = 0;                // behind the screen, of the campaign
    int levels = 1;               // of the campaign
    bool begun = false;           // whether there is something to go on with
    bool stayed = false;          // the level is solved and the player knows
    bool once = false;            // what is played is recorded or replayed: it cannot begin again
    // The first level that is not solved, if any: the last one leads there.
    std::optional<int> unsolved = std::nullopt;

    bool operator==(const Screens&) const = default;
};

enum class Happening {
    play,      // the level that is there, as it is
    begin,     // the first level, from its beginning
    choose,    // level `Event::level`, from its beginning
    pause,     // the menu key while playing, or a window that is left
    back,      // the menu key, Esc, or a gamepad's B, on another screen
    levels,    // to the level choice
    options,   // to the options
    credits,   // to who and what made it
    controls,  // to what keys and buttons mean
    title,     // to the title
    reset,     // the level in play, from its beginning: asks, and is the answer there
    solved,    // the level in play is solved
    next,      // the level after it, after the last the first that is not solved
    quit,
};

struct Event {
    Happening what = Happening::back;
    int level = 0;
};

// What has to be done on the way to the new screen.
enum class Effect {
    none,
    load,    // the level of the new state, from its beginning
    keep,    // write down how far the player has come
    quit,    // the same, and end
    refuse,  // say that it cannot begin again
};

struct Change {
    Screens to;
    Effect effect = Effect::none;
};

// Events that mean nothing on the screen leave everything as it is.
Change follow(const Screens& from, const Event& event);

// Whether the player's keys move her: else the mouse is free.
inline bool is_played(Screen screen) {
    return screen == Screen::play;
}

// Whether the simulation goes on. The title shows a living scene; the level is finished while its light
// goes on playing.
inline bool is_running(Screen screen) {
    return screen == Screen::play || screen == Screen::title || screen == Screen::finished;
}

}  // namespace lanthorn::game
