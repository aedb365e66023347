// Going to any step of a recording.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tools/lanthorn/replay/replayed_level.h"
#include "tools/lanthorn/replay/state_cache.h"

namespace lanthorn::tools {

// From the last state that is known, not before where the replay is now; keeps those that it passes for the
// next time. Returns the step that it began to play at. At most kKeySteps steps where the cache is full.
std::uint64_t seek(ReplayedLevel& replayed, std::uint64_t step, const StateCache& cache);

// The states before every `every`th key step, as this build plays the recording. Throws InputError where they
// are not as recorded.
std::vector<replay::StoredState> key_states(const LevelFile& level, const std::string& file,
                                            const std::shared_ptr<const replay::Recording>& recording,
                                            std::uint64_t every);

}  // namespace lanthorn::tools
