// What a simulation step takes in from the player: whole numbers, so that a recording holds exactly what was
// played.
#pragma once

#include <cstdint>

namespace lanthorn::game {

enum Button : std::uint16_t {
    kUse = 1,    // open or close the door at hand
    kLight = 2,  // light or put out the lantern
    kCarry = 4,  // pick the lantern up or put it down
};

struct PlayerInput {
    std::int16_t forward = 0;  // -32767..32767: full speed back..forward
    std::int16_t right = 0;    // -32767..32767: full speed left..right
    std::int16_t yaw = 0;      // turn since the last step, kLookUnit radians; positive to the left
    std::int16_t pitch = 0;    // likewise; positive up
    std::uint16_t held = 0;    // Button bits that are down
    std::uint16_t unused = 0;  // no padding: inputs are compared and stored as bytes

    bool operator==(const PlayerInput&) const = default;
};
static_assert(sizeof(PlayerInput) == 12);

inline constexpr double kLookUnit = 1.0 / 8192;  // radians
inline constexpr const char* kInputFormat = "lamplighter-1";

// `value` in -1..1 (clamped) as forward and right hold it.
std::int16_t axis(double value);
// Radians as yaw and pitch hold them, at most 4 either way a step.
std::int16_t look(double radians);

}  // namespace lanthorn::game
