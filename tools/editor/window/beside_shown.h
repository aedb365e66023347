// What was expected beside what was found: of two plays of one session, at one step.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::edit_window {

// A field that differs.
struct BesideRow {
    std::uint32_t node = kNone;  // of the document; none: of a resource, or of what is not in the file
    std::string name;            // "green-pane: pushed.share"
    std::string found, expected;
};

struct BesideShown {
    std::string title;            // "step 503 of pool.rec"
    std::vector<BesideRow> rows;  // as many as are told
    bool more = false;            // there are further ones
    // Where nodes stand that stand otherwise: from what was found to what was expected, in the world.
    std::map<std::uint32_t, dmat4> to_expected;

    bool empty() const { return title.empty(); }
};

}  // namespace lanthorn::edit_window
