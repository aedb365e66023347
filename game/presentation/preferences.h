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
    double mouse = 1;          // how far a move of the mouse turns the view, 0.2..4
    bool invert_look = false;  // mouse or stick forward looks down
    double text_size = 1;      // 0.75..2
    double effects = 0.8;      // how loud, 0..1
    double music = 0.7;        // likewise
    bool symbols = false;      // a shape beside each colour that matters
    bool less_motion = false;  // no camera moves that the player does not make

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
