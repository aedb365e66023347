// Edits done again on another export of their file.
#pragma once

#include <string>
#include <vector>

#include "tools/editor/core/command.h"
#include "tools/editor/core/edit_history.h"

namespace lanthorn::editor {

// A command that no longer fits: kept, not applied.
struct LeftCommand {
    Command command;
    std::string why;      // one line
    std::string nearest;  // the path of what it may have become; empty: nothing like it
};

struct Rebased {
    std::size_t kept = 0;
    std::vector<LeftCommand> left;
};

}  // namespace lanthorn::editor
