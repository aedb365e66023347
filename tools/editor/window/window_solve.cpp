// Still solvable? The level's recording, played in a process of its own.
#include <chrono>
#include <utility>

#include "lanthorn/core/error.h"
#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

namespace {

constexpr int kNiceness = 10;       // the hand comes first
constexpr double kLookEvery = 0.5;  // seconds

}  // namespace

void EditorWindow::State::ask_solvable() {
    EditorState& e = *editor;
    if (solver.running()) {
        solve_dropped = true;
        solver.stop();
        return;
    }
    e.drawer_tab = kSolveTab;
    if (!std::exchange(e.splits.drawer_open, true)) {
        e.pace.changed(now(), false);
    }
    if (!options.solve) {
        e.say("this editor has no game whose levels are solved", now());
        return;
    }
    try {
        const std::filesystem::path folder = solver.make_folder("lanthorn-solve-XXXXXX");
        (void)solver.take_end();  // of one that another file has dropped
        solver.start(options.solve(session, folder), kNiceness);
        solver_folder = folder;
        solve_dropped = false;
        e.solve = {};
        e.solving = true;
        e.solve_version = session.version();
    } catch (const Error& error) {
        e.problem = error.what();
    }
}

void EditorWindow::State::follow_solving() {
    EditorState& e = *editor;
    if (!e.solving) {
        return;
    }
    const std::optional<std::string> end = solver.take_end();
    if (!end && now() - solve_looked < kLookEvery) {
        return;
    }
    solve_looked = now();
    settling = kSettlingFrames;
    try {
        e.solve = options.solve_found(solver_folder);
    } catch (const Error& error) {
        e.problem = error.what();
    }
    if (!end) {
        solver_alarm.set(Alarm::Clock::now() +
                         std::chrono::milliseconds(static_cast<int>(1000 * kLookEvery)));
        return;
    }
    e.solving = false;
    if (solve_dropped) {
        e.solve = {};
    } else if (e.solve.solved) {
        e.say(e.solve.words, now());
    } else {
        e.problem = "still solvable?: " + *end;
    }
}

}  // namespace lanthorn::edit_window
