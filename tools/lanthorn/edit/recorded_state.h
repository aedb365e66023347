// A scene as a recorded session of lamplighter leaves it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tools/editor/core/edit_session.h"
#include "tools/editor/window/played_shown.h"

namespace lanthorn::tools {

struct RecordedState {
    edit_window::PlayedScene scene;
    std::uint64_t step = 0;                     // of the end
    std::optional<workbench::CameraPose> eyes;  // the player's, then; none: nobody looks
};

// Plays the recording of that level again, up to the step, or to its end. Throws InputError where the
// recording is of another level or has no such step.
RecordedState recorded_state(const std::string& file, const std::string& level,
                             std::optional<std::uint64_t> step);

// FILE:STEP. Throws InputError for anything else.
struct RecordedPlace {
    std::string file;
    std::uint64_t step = 0;
};
RecordedPlace recorded_place(const std::string& at);

// `at`: FILE:STEP, a recording of the file that the session has opened. What stands otherwise there becomes
// one step, and the session looks from where the player did. Throws InputError.
void show_recorded(editor::EditSession& session, const std::string& at);

}  // namespace lanthorn::tools
