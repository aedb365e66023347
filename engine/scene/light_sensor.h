// A place whose light the simulation reacts to: a solar cell, a plant, a door that opens in the sun.
#pragma once

#include <cstdint>

namespace lanthorn {

// Measures the light that arrives on the surface at its node's place, facing the node's +Y. What is rendered
// says how much that is; it enters the simulation as a recorded input, so that a replay reads the same.
struct LightSensor {
    float radius = 0.25f;        // metres about the node that are averaged
    float interval = 0.1f;       // seconds at least between two readings
    float lux = 0;               // the last reading; 0 before the first
    std::uint64_t readings = 0;  // how many there were

    bool operator==(const LightSensor&) const = default;
};

}  // namespace lanthorn
