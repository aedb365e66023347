// What a player has chosen on the options screen, kept from one run to the next.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lanthorn/core/math.h"
#include "lanthorn/shell/kept_file.h"

namespace lanthorn::game {

struct Preferences {
    ivec2 picture{0};    // pixels, 16..8192; 0: as picture_size() has it
    std::string preset;  // low, medium, high, ultra; empty: medium, on the CPU low
    bool fullscreen = false;
    // Milliseconds that a frame may take, 0..1000; 0: as long as it takes; none: as the machine has it.
    std::optional<double> frame_budget;
    double field_of_view = 56;   // degrees upwards, in windows of 4:3 and wider, 50..90
    double brightness = 0;       // stops more than the exposure says, -1..1
    double mouse = 1;            // how far a move of the mouse turns the view, 0.2..4
    double stick = 1;            // how fast a tilted stick does, 0.2..4
    double dead_zone = 0.18;     // share of a stick's way around its middle in which it rests, 0..0.5
    bool invert_look = false;    // mouse or stick forward looks down
    bool hold_by_press = false;  // what is turned while a key is held: a press begins it, another ends it
    double text_size = 1;        // 0.75..2
    double effects = 0.8;        // how loud, 0..1
    double music = 0.7;          // likewise
    bool captions = false;       // what is heard, in words
    bool symbols = false;        // a shape beside each colour that matters
    bool less_motion = false;    // no camera moves that the player does not make
    bool flicker = true;         // flames waver
    bool rim = true;             // figures have light along their outlines
    std::string language;        // its file's name without the ending; empty: the system's

    bool operator==(const Preferences&) const = default;
};

inline constexpr int kPreferencesVersion = 1;

// JSON with a trailing newline, and back. What is missing takes its default, unknown names are left out.
// Throws InputError naming `source` and the member for what is no JSON, of another version, of another type
// or out of range.
std::string to_json(const Preferences& preferences);
Preferences preferences_from_json(std::string_view json, std::string_view source);

// The file's, or the defaults; a damaged file is put aside and said.
Preferences read_preferences(shell::KeptFile& file);

}  // namespace lanthorn::game
