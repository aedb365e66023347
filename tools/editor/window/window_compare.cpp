// A|B of two ways to draw: the second view of the App.
#include <utility>

#include "lanthorn/gi/gi_plugin.h"
#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

void EditorWindow::State::follow_other_side(bool settings_changed) {
    EditorState& e = *editor;
    if (e.other_side == shown_side && !settings_changed) {
        return;
    }
    const bool live = e.other_side && e.other_side->as && session.is_open();
    App& app = session.app();
    if (live && !other_view) {
        // Light is compared: what is brighter looks brighter.
        other_view = app.add_view({.size = ivec2(0), .name = "A", .exposed_as = ViewId::first});
    } else if (!live && other_view) {
        app.remove_view(*std::exchange(other_view, std::nullopt));
    }
    if (live) {
        gi::apply_settings(app, shown_settings(e.other_side->as->settings), *other_view);
    }
    if (e.other_side != shown_side) {
        if (!live) {
            e.picture.forget_other();
        }
        shown_side = e.other_side;
        e.pace.changed(now(), false);
        settling = kSettlingFrames;
    }
}

}  // namespace lanthorn::edit_window
