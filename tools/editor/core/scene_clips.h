// The clips of the file that is edited: what a timeline shows, and which of them the file begins with.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/editor/core/edit_session.h"

namespace lanthorn::editor {

struct ClipRow {
    std::string name;                  // as the file has it; empty: none
    std::string key;                   // by what it is found: its name, or its number where that says nothing
    double seconds = 0;                // its length
    double rate = 60;                  // frames a second that its keys stand at
    std::vector<std::uint32_t> nodes;  // of the document that it moves, or whose light or camera; ascending
    std::vector<float> keys;           // seconds at which something has one, ascending
};

// In the file's order. O(keys).
std::vector<ClipRow> clip_rows(EditSession& session);
// Whether a clip moves the node, or one below it.
bool moves(const ClipRow& clip, const EditModel& model, std::uint32_t node);

// The key of the clip that the file begins with; "none": it wants none, or names one that it has not; empty:
// it has no clips.
std::string start_clip(EditSession& session, const std::vector<ClipRow>& clips);
// The command that makes it begin with that clip ("none": with none).
std::string start_clip_line(EditSession& session, const std::string& key);

}  // namespace lanthorn::editor
