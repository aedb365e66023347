// What a timeline does to the world, between two frames.
#include <algorithm>
#include <utility>

#include "lanthorn/core/error.h"
#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

void EditorWindow::State::follow_timeline() {
    EditorState& e = *editor;
    TimelineShown& line = e.timeline;
    if (!session.is_open()) {
        line.playing = false;
        return;
    }
    line.play_on(now());
    if (!std::exchange(line.moved, false)) {
        return;
    }
    try {
        // Of a clip that starts again the end is its beginning: the end itself is shown a moment before.
        const editor::ClipRow* clip = line.shown();
        const double last = clip == nullptr ? 0 : clip->seconds * (1 - 1e-9);
        session.show_moment(line.clip, std::min(line.second(), last));
    } catch (const Error& error) {
        e.problem = error.what();
        line.playing = false;
        line.clip.reset();
    }
    e.pace.changed(now(), true);
    settling = kSettlingFrames;
}

}  // namespace lanthorn::edit_window
