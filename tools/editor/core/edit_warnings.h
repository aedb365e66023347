// What may be wrong with a scene's light, each with the node that it is about and, where there is one, the
// command that puts it right.
#pragma once

#include <string>
#include <vector>

#include "tools/editor/core/edit_session.h"

namespace lanthorn::editor {

struct EditWarning {
    std::string kind;  // "watts", "guest", "range", ...: what 'never mind' remembers
    std::string text;  // one line
    std::uint32_t node = kNone;
    std::string fix;  // a command of EditSession::run(), lines joined by \n; empty: none
};

// In the order in which they matter. O(nodes + materials).
std::vector<EditWarning> edit_warnings(EditSession& session);

}  // namespace lanthorn::editor
