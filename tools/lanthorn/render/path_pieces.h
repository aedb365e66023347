// Tracing a picture's paths by several processes, of this machine or of a cluster (docs/farm.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/reference/path_tracer.h"
#include "tools/replay_suite/farm_tasks.h"

namespace lanthorn::tools {

struct PieceChoice {
    suite::FarmChoice farm{"", 1, {}};
    std::optional<int> pieces;  // at least
    std::string piece;          // what this process is to trace itself; empty: a picture

    // Whether other processes trace.
    bool by_others() const { return !farm.executor.empty() || farm.jobs > 1; }
};

// "64:32:0:90": the first sample, how many, the top row, how many. Throws InputError for anything else, and
// for what lies outside of a picture of that size and so many samples.
reference::PathPiece parse_piece(const std::string& text, ivec2 size, int spp);

// What a piece's process needs of `lanthorn render`, without what is written.
struct PieceCommand {
    std::vector<std::string> arguments;  // the scene, and how it is shown
    std::string settings;                // JSON
};

// Has all samples of a picture traced, in pieces that lie in `folder` until they are added up: the same call
// finds those that are there. The folder is gone then. Throws as do_tasks().
void trace_in_pieces(reference::PathTracer& tracer, ivec2 size, int spp, const PieceCommand& command,
                     const PieceChoice& choice, const std::string& folder);

}  // namespace lanthorn::tools
