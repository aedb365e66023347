// Playing the scene that is edited: the game in a window of its own, from where one looks.
#include <fmt/format.h>

#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

void EditorWindow::State::play_here() {
    EditorState& e = *editor;
    if (!options.play) {
        e.say("this editor has no game to play in", now());
        return;
    }
    if (game.running()) {
        e.say("the game runs already: Esc ends it", now());
        return;
    }
    try {
        const std::filesystem::path level = game.make_folder() / "level.glb";
        game.start(options.play(session, e.settings, level, window.framebuffer_size()));
        e.playing = true;
        e.say("playing from here, in a window of its own; Esc there comes back", now());
    } catch (const Error& error) {
        e.problem = error.what();
    }
}

void EditorWindow::State::follow_play() {
    EditorState& e = *editor;
    if (const std::optional<std::string> end = game.take_end()) {
        e.playing = false;
        if (!end->empty()) {
            e.problem = "the game: " + *end;
        } else {
            e.say("back from playing: nothing of it has changed the scene", now());
        }
        glfwFocusWindow(window.context().handle());
        settling = kSettlingFrames;
    }
}

}  // namespace lanthorn::edit_window
