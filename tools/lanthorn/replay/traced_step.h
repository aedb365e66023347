// One step of a replay, looked at after each of its systems.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/lanthorn/replay/replayed_level.h"

namespace lanthorn::tools {

struct SystemState {
    std::string system;                 // "physics", "physics (commands)"
    std::vector<std::uint64_t> hashes;  // one a part, after it
};

struct TracedStep {
    std::vector<std::string> parts;
    std::vector<SystemState> systems;  // in their order
    std::string state;                 // ecs::Snapshot's bytes, after the system asked for or the whole step
};

// Plays until `step` steps are done, then one more, traced. The replay must not be further than that.
// `after`: the system whose state is kept; empty: the last.
TracedStep trace_step(ReplayedLevel& replayed, std::uint64_t step, const std::string& after);

// Where two traces of one step part.
struct TraceDifference {
    std::size_t system = 0;          // position in `found`: the first after which a part differs
    std::string there;               // the system of `expected` to compare with: the same, or that before it
    std::vector<std::string> parts;  // that differ, of those that both have
};
// A system that is in `found` alone is named where it made the difference. Nothing where no part differs.
std::optional<TraceDifference> first_difference(const TracedStep& found, const TracedStep& expected);

// OUT.json and OUT.state, whole or not at all; and back. Throw InputError.
void write_trace(const std::string& out, const TracedStep& trace);
TracedStep read_trace(const std::string& out);

}  // namespace lanthorn::tools
