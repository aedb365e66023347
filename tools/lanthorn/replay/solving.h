// Whether a level that was changed is still solved by what a player once did in it: the recorded inputs, with
// light sensors that read the level as it is now.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lanthorn::tools {

struct Solving {
    // What is to happen: a crystal that wakes, a goal that is reached, and what the recording expects.
    struct Event {
        std::string what;          // "ruby wakes", "door door.open"
        std::string crystal = {};  // its name; empty: it is about none
        std::optional<std::uint64_t>
            recorded;                      // after that step; none: not known, or it did not happen there
        std::optional<std::uint64_t> now;  // none: it does not happen
    };
    // What a crystal or a goal has read.
    struct Reading {
        std::string name;
        double needed = 0, most = 0;  // lux, through its filter
        double seconds = 0;           // of them that a crystal takes to wake; 0: a goal
        double charge = 0;            // 0..1: the most that has come together
        std::uint64_t most_at = 0;    // steps
    };
    std::uint64_t steps = 0;
    std::optional<std::uint64_t> solved_at, recorded_at;
    std::vector<Event> events;  // in the order of the recording
    std::vector<Reading> readings;

    // The first event that does not happen; null: all do.
    const Event* first_missing() const;
    const Reading* reading(const std::string& name) const;  // null: there is none
    // "solved at step 1406 (23.4 s)", "not solved: ruby had at most 0.31 lx (step 1290), needs 0.5 lx for 2
    // s;
    // ...": one line.
    std::string words() const;
};

// Plays the recording's inputs in `level`, drawn small every few steps so that its sensors read, and five
// seconds on where it is not solved by then: light may come together a little later. `at_step` is called
// after each and ends it by false. What is recorded is taken from the level that was recorded, where that is
// still at hand. Throws InputError where recording or level cannot be read or played, Error(no_gl) without
// OpenGL.
Solving solve_again(const std::string& recording, const std::string& level,
                    const std::function<bool(std::uint64_t step, std::uint64_t steps)>& at_step);

// The recording of a level: NAME.rec beside it, or in the project's tests/replay. Empty: there is none.
std::filesystem::path recording_of(const std::filesystem::path& level);

std::string to_json(const Solving& solving);

}  // namespace lanthorn::tools
