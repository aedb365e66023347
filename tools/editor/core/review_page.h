// What a person is asked to agree to: a page with the scene before and after the edits, its light measured,
// and the text that changes. One file that opens from disk without a network.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lanthorn/core/settings.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/core/same_as_game.h"

namespace lanthorn::editor {

struct ReviewView {
    std::string name;
    workbench::CameraPose pose;
};

// Writes the page: each view as the file on disk has it (a scene in no file yet: as it began) and as it is
// now, both by a fresh App of the bytes, with the picture, its lux and its error against the path tracer (64
// samples). Needs a current OpenGL context. Throws InputError where the page cannot be written or the file
// cannot be read; nothing is written then. O(views * frames).
void write_review(const EditSession& session, const Settings& settings, const std::vector<ReviewView>& views,
                  const CheckedFrames& what, const std::filesystem::path& page);

}  // namespace lanthorn::editor
