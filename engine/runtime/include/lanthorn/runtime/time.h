// Where simulation and picture are in time: a resource of every App.
#pragma once

#include <cstdint>

#include "lanthorn/core/time_step.h"

namespace lanthorn {

// The simulation is at the end of its last step. What a frame shows is a moment between the step before that
// and the last one: a step is simulated as soon as a frame needs its end.
struct Time {
    std::uint64_t steps = 0;  // simulated so far; in a fixed step: this one is among them
    double moment = 0;        // seconds since the start that the frame shows
    double blend = 1;         // of the way from the step before to the last one; 1: the last one itself

    std::uint64_t key_every = kKeySteps;  // steps; other numbers are for tests of what follows

    // In a fixed step: this one is a key step. Before it whatever is not in components, the memory of
    // contacts for one, is thrown away, in every run: from there on states depend on components alone, and a
    // snapshot of the state before it is enough to go on from, bit for bit.
    bool at_key_step() const { return steps > 1 && (steps - 1) % key_every == 0; }

    double simulated() const { return static_cast<double>(steps) / kStepsPerSecond; }  // seconds
    // From the frame's moment to the last step's end, seconds; 0 or more.
    double ahead() const { return (1 - blend) * kStepSeconds; }
};

}  // namespace lanthorn
