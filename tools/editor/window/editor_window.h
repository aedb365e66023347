// The editor's window: panels over a scene that is shown with the game's own light.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lanthorn/core/settings.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/window/beside_shown.h"
#include "tools/editor/window/played_shown.h"
#include "tools/editor/window/solve_shown.h"

namespace lanthorn::edit_window {

struct EditorState;

struct EditorOptions {
    std::filesystem::path scene = {};  // empty: the start screen
    editor::SessionOptions session = {};
    ivec2 size{1280, 720};  // pixels
    // Called once `scene` has been opened: edits that it begins with. Throws InputError.
    std::function<void(editor::EditSession&)> opened = {};
    BesideShown beside = {};                  // shown over it
    double text_scale = 0;                    // 0.75..2; 0: what the screen asks for
    std::string technique = {}, preset = {};  // empty: the default, and what suits the device
    bool refine = true;                       // what is still is drawn on (refinement.h)
    std::filesystem::path report = {};        // lines of JSON about what is drawn; empty: none
    std::filesystem::path recent =
        {};  // file that keeps the names of files that were open, beside one of their views; empty: none
    std::vector<std::filesystem::path> levels = {};  // offered at the start
    // Writes the session's scene into a file as a level that is played from its pose, in a window of that
    // size, and gives the command line that plays it; throws InputError where it cannot. Empty: there is no
    // game.
    std::function<std::vector<std::string>(const editor::EditSession&, const Settings&,
                                           const std::filesystem::path& level, ivec2 size)>
        play = {};
    // After that has ended: what it was at its beginning and at its end, from the folder of the level. Called
    // on a thread of its own; throws InputError where that cannot be said. Empty: nothing of it is offered.
    std::function<PlayedScene(const std::filesystem::path& folder)> played = {};
    // Whether the scene can still be solved as somebody once solved it: writes what is needed into that
    // folder and gives the command line that finds out; throws InputError where nobody has. Empty: nothing is
    // solved.
    std::function<std::vector<std::string>(const editor::EditSession&, const std::filesystem::path& folder)>
        solve = {};
    // What it has found so far, from the folder.
    std::function<SolveShown(const std::filesystem::path& folder)> solve_found = {};
};

class EditorWindow {
  public:
    // Opens the window. Throws Error(ExitCode::no_gl) without a display or usable OpenGL, InputError for a
    // scene that cannot be read.
    explicit EditorWindow(EditorOptions options);
    ~EditorWindow();
    EditorWindow(const EditorWindow&) = delete;
    EditorWindow& operator=(const EditorWindow&) = delete;

    // Until the person closes it. Asleep whenever nothing changes.
    void run();
    // One turn of that: waits where nothing is to be done, takes in what has happened, draws. False: it ends.
    bool turn();
    // The next turn waits until something happens.
    bool asleep() const;
    void wake();  // the next turn does not wait
    const EditorState& state() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lanthorn::edit_window
