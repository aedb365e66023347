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

// Does `steps` on `history`, the new export as it was opened, finding nodes by their marks: by the path
// first, then by name, mesh and place. What does not fit is left, and so is what stands on it: a node that
// was made by a command that is left is in no other. kept + left.size() is the number of commands. `context`
// is of the new export.
Rebased rebase(const std::vector<EditStep>& steps, EditHistory& history, const CommandContext& context);

}  // namespace lanthorn::editor
