// A light meter in the scene: something that the simulation reacts to, as a solar cell does.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn {

// Measures the light that falls on a disc around its entity's origin, on the side that its -Z looks to: the
// illuminance in lux, direct and indirect light together, averaged over the disc. Its place is on a surface
// (a plate, a wall) that looks the same way and goes on as far as the disc does: indirect light is counted
// where it arrives, on surfaces.
//
// It sees through a filter: the reading is the sum of the channels' illuminances, each times its weight.
// Weights below 0 make it blind for other colours: {1, -1.2, -1.2} reads more than 0 in red light, and less
// in white.
//
// What is rendered says how much light that is. It comes back some frames later (runtime/sensor_plugin.h) and
// enters the simulation as a recorded input, so that a replay reads the same.
struct LightSensor {
    float radius = 0.5f;                     // metres; of the disc: a larger one has less noise
    vec3 filter{0.2126f, 0.7152f, 0.0722f};  // of linear Rec. 709 red, green, blue: the luminance
    float lux = 0;                           // the last reading; 0 before the first
    std::uint64_t readings = 0;              // how many there were
    bool operator==(const LightSensor&) const = default;
};

// How bright it is to be somewhere: kept in the file, watched by the editor and `lanthorn measure contracts`;
// the simulation does not read it. Beside a LightSensor it is of what that reads, else of all surfaces within
// a box around its entity's origin, along its axes.
struct LightContract {
    float lower = 0;      // lux
    float upper = 0;      // lux; 0: no limit
    vec3 size{1};         // of the box, metres
    float share = 0.95f;  // of the surfaces' area that must be within; the rest may be dark corners, or lamps
    bool operator==(const LightContract&) const = default;
};

// A reading, as the simulation takes it in.
struct SensorSample {
    std::uint32_t id = 0;    // the entity's index
    std::uint64_t step = 0;  // of the state that was looked at (Time::steps)
    float lux = 0;           // through the sensor's filter
};

// What has come back and enters the simulation with its next step (resource). Whoever records or replays a
// session reads it, or puts recorded samples in its place, before `sensors.read`.
struct SensorInbox {
    std::vector<SensorSample> samples;
};

}  // namespace lanthorn
