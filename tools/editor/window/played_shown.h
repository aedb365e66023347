// What was changed in play, as it is offered.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <vector>

#include "tools/editor/core/play_changes.h"

namespace lanthorn::edit_window {

// A scene that was played: as it began, and as it was at the end.
struct PlayedScene {
    std::map<std::uint32_t, editor::PlayedNode> before, after;
    std::vector<std::uint32_t> animated;  // nodes that clips move
};

struct PlayedRow {
    editor::PlayChange change;
    bool keep = false;
};

}  // namespace lanthorn::edit_window
