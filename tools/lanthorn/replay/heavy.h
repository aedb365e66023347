// Proves that a state is all there is: saved, loaded into another App and gone on from, it leads to the same
// bits. So it is enough to seek by.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "tools/lanthorn/replay/replayed_level.h"
#include "tools/lanthorn/replay/verdict.h"

namespace lanthorn::tools {

// At every `every`th step of the recording's inputs, with every step a key step; and from each real key step
// to the next, against the recording.
Check heavy_check(const LevelFile& level, const std::string& file,
                  const std::shared_ptr<const replay::Recording>& recording, std::uint64_t every,
                  const ReplayChoice& choice = {});

}  // namespace lanthorn::tools
