// Where two plays of the same inputs part: step, part, system, entity, field.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/lanthorn/replay/field_differences.h"
#include "tools/lanthorn/replay/reference.h"

namespace lanthorn::tools {

struct Cause {
    std::uint64_t step = 0;
    std::vector<std::string> parts;  // that differ after the system
    std::string system;              // the first after which something differs
    std::size_t position = 0;        // of it among the systems of a fixed step, from 1
    std::size_t systems = 0;         // how many there are
    std::vector<FieldDifference> fields;
    bool more = false;  // fields there are

    // Same system, same field, same sign: another symptom of the same fault.
    bool same_as(const Cause& other) const;
};

// What is played here and differs from the reference in step `step`, before which both are equal. Nothing
// where no system makes a difference. `likely`: the system that it probably is, which saves half the work.
std::optional<Cause> find_cause(const LevelFile& level, const replay::Recording& inputs, std::uint64_t step,
                                const ReplayChoice& here, Reference& reference, std::size_t most_fields = 20,
                                const std::string& likely = "");

// The first step whose state is another here than `expected` has it; nothing: none.
std::optional<std::uint64_t> first_unequal(const LevelFile& level, const replay::Recording& expected,
                                           const ReplayChoice& here);

}  // namespace lanthorn::tools
