// The game's sounds, made when it starts: no files.
#pragma once

#include <vector>

#include "lanthorn/audio/heard.h"
#include "lanthorn/audio/speaker.h"

namespace lanthorn::game {

// Numbers of effects, as a Sound names them.
struct SoundKind {
    enum Name : audio::Kind {
        // Played once.
        step_left,
        step_right,
        take,
        put_down,
        lantern_on,
        lantern_off,
        brighter,
        darker,
        glass,
        door_shut,
        shutter_stops,
        crystal_wakes,
        solved,
        choose,  // on the screens
        change,  // a value there
        // Played as long as something goes on.
        door_moves,
        shutter_slides,
        pushed,
        turned,
        crystal_charges,
    };
};
inline constexpr int kSoundKinds = static_cast<int>(SoundKind::crystal_charges) + 1;

constexpr bool goes_on(SoundKind::Name kind) {
    return kind >= SoundKind::door_moves;
}

// Its peak is below 1, and begins and ends at 0; of what goes on the end leads into the beginning. Cost: all
// effects together some 60 ms.
audio::Samples synthesise(SoundKind::Name kind);

// All of them, by their number.
std::vector<audio::Effect> effects();

}  // namespace lanthorn::game
