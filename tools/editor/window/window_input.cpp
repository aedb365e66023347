// Where keys, clicks and dropped files go.
#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

void EditorWindow::State::take_key(const Happening& happening) {
    EditorState& e = *editor;
    const Act what = act_of(e.keymap, happening.code, happening.modifiers);
    if (what == Act::deselect) {
        act(what);
        return;
    }
    // What is typed is not meant for the picture; nor is what a sheet lies over.
    if (typing ||
        (e.sheet != Sheet::none && what != Act::help && what != Act::quit && what != Act::larger_text &&
         what != Act::smaller_text && what != Act::open && what != Act::new_room)) {
        return;
    }
    act(what);
}

void EditorWindow::State::take_drop(const Happening& happening) {
    EditorState& e = *editor;
    if (happening.files.empty()) {
        return;
    }
    const std::filesystem::path file = happening.files.front();
    if (session.is_open() && e.dirty && drop_again != file) {
        drop_again = file;
        e.say("there are unsaved edits: drop it once more to open it all the same", now());
    } else {
        drop_again.clear();
        e.open(file);
    }
}

void EditorWindow::State::take_events() {
    EditorState& e = *editor;
    while (const auto happening = input.next()) {
        settling = kSettlingFrames;
        const bool over =
            !popup && e.sheet == Sheet::none && session.is_open() && e.layout.picture.contains(happening->at);
        if (happening->kind == Happening::Kind::drop) {
            take_drop(*happening);
            continue;
        }
        if (over && happening->kind == Happening::Kind::press && e.game_button.contains(happening->at)) {
            act(Act::check_game);
            continue;
        }
        if (over && happening->kind == Happening::Kind::press && e.cancel_button.contains(happening->at)) {
            leave_reference();
            continue;
        }
        if (over && happening->kind == Happening::Kind::press && e.compare_button.contains(happening->at)) {
            act(Act::compare_menu);
            continue;
        }
        const bool was_gesture = viewport->gesture();
        if ((happening->kind != Happening::Kind::key || !typing) && viewport->take(*happening, over)) {
            if (viewport->gesture() && was_gesture && e.desk.waiting() && hand_at == 0) {
                hand_at = happening->time;
            }
            continue;
        }
        if (happening->kind == Happening::Kind::key) {
            take_key(*happening);
        }
    }
}

}  // namespace lanthorn::edit_window
