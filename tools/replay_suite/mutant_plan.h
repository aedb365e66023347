// Which faults a suite makes to see whether it would notice: state mutants, each of which must be caught by
// name, the part of the state that was altered at the step at which it was; and faults in pictures at marks.
#pragma once

#include <string>
#include <vector>

#include "tools/replay_suite/plan.h"
#include "tools/replay_suite/result.h"

namespace lanthorn::suite {

// Of every recording that passed, runs that tell what each system changes in some steps.
std::vector<Item> watch_items(const std::vector<Item>& replays, const std::vector<Result>& results);

// At most `most` mutants of `replays` that passed, the same for the same plan: of every recording, one bit of
// each part of its state, two entities that swap a part, each system that changed something in a watched step
// skipped in it, an input dropped; at steps that a counter-based random number chooses. Kinds and recordings
// in turn, so that fewer are still of every kind. `results` include those of watch_items().
std::vector<Item> mutant_items(const std::vector<Item>& replays, const std::vector<Result>& results,
                               int most);

// At most `most` faults in pictures: at every mark whose picture passed each of kBlemishes. Marks and faults
// in turn, so that fewer are still of every mark and kind.
std::vector<Item> blemish_items(const std::vector<Item>& replays, const std::vector<Result>& results,
                                int most);

// Of `verify --picture-fault`, the subtlest first.
inline constexpr const char* kBlemishes[] = {"lamp",  "shadow",   "off",  "nan",
                                             "moved", "indirect", "half", "black"};

}  // namespace lanthorn::suite
