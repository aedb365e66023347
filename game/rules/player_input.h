// What a simulation step takes in from the player: whole numbers, so that a recording holds exactly what was
// played.
#pragma once

#include <cstdint>

#include "lanthorn/input/turn.h"

namespace lanthorn::game {

// What the player can do besides walking and looking. A press is a bit that is down and was not in the step
// before.
enum Button : std::uint16_t {
    kUse = 1 << 0,      // what is at hand: open or shut doors and shutters, turn turntables
    kLight = 1 << 1,    // light or put out the lantern
    kCarry = 1 << 2,    // pick the lantern up or put it down
    kDimUp = 1 << 3,    // brighter
    kDimDown = 1 << 4,  // darker
    kColour = 1 << 5,   // the lantern's next colour
    kView = 1 << 6,     // with her eyes, or from behind her
    kHint = 1 << 7,     // say what to do here
    kReset = 1 << 8,    // the level from its beginning
};

struct PlayerInput {
    std::int16_t forward = 0;  // -32767..32767: full speed back..forward
    std::int16_t right = 0;    // -32767..32767: full speed left..right
    std::int16_t yaw = 0;      // turn since the last step, input::kTurnUnit; positive to the left
    std::int16_t pitch = 0;    // likewise; positive up
    std::uint16_t held = 0;    // Button bits that are down
    std::uint16_t unused = 0;  // no padding: inputs are compared and stored as bytes

    bool operator==(const PlayerInput&) const = default;
};
static_assert(sizeof(PlayerInput) == 12);

inline constexpr const char* kInputFormat = "lamplighter-1";

// `value` in -1..1 (clamped) as forward and right hold it.
std::int16_t axis(double value);

}  // namespace lanthorn::game
