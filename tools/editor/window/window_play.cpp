// Playing the scene that is edited: the game in a window of its own, from where one looks; and what was
// changed there, which is offered.
#include <fmt/format.h>

#include <chrono>

#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

void EditorWindow::State::play_here() {
    EditorState& e = *editor;
    if (!options.play) {
        e.say("this editor has no game to play in", now());
        return;
    }
    if (game.running() || played.valid()) {
        e.say("the game runs already: Esc ends it", now());
        return;
    }
    try {
        const std::filesystem::path folder = game.make_folder("lanthorn-play-XXXXXX");
        game.start(options.play(session, e.settings, folder / "level.glb", window.framebuffer_size()));
        played_folder = folder;
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
        e.played.clear();
        if (!end->empty()) {
            e.problem = "the game: " + *end;
        } else {
            e.say("back from playing: nothing of it has changed the scene", now());
            look_at_played();
        }
        glfwFocusWindow(window.context().handle());
        settling = kSettlingFrames;
    }
    if (!played.valid() || played.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        return;
    }
    settling = kSettlingFrames;
    try {
        const PlayedScene scene = played.get();
        for (editor::PlayChange& change :
             play_changes(session.model(), scene.before, scene.after, scene.animated)) {
            e.played.push_back({std::move(change), false});
        }
        if (!e.played.empty()) {
            e.say(fmt::format("back from playing: nothing of it has changed the scene; {} thing{} stand{} "
                              "otherwise there: see Played",
                              e.played.size(), e.played.size() == 1 ? "" : "s",
                              e.played.size() == 1 ? "s" : ""),
                  now());
        }
    } catch (const Error& error) {
        e.problem = error.what();
    }
}

// On another thread: all that was played is played again.
void EditorWindow::State::look_at_played() {
    if (!options.played) {
        return;
    }
    played = std::async(std::launch::async, [this, look = options.played, folder = played_folder] {
        struct Wake {
            EditorWindow::State& state;
            ~Wake() { state.window.request_frame(); }
        };
        const Wake wake{*this};
        return look(folder);
    });
}

}  // namespace lanthorn::edit_window
