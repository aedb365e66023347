// Light wishes: looked at while the hand rests, and solved as one step.
#include <algorithm>

#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

void EditorWindow::State::take_wishes(WishSolver::Answer answer) {
    EditorState& e = *editor;
    WishesShown& wishes = e.wishes;
    wishes.busy = false;
    settling = kSettlingFrames;
    if (!answer.problem.empty()) {
        e.problem = answer.problem;
        wishes.solve = false;
        wishes.found_edition = asked_wishes;  // no more of it comes
        wishes.found_version = asked_version;
        return;
    }
    if (asked_wishes != wishes.edition || asked_version != session.version()) {
        return;  // of what is not so any more
    }
    // A hand may be making one more.
    const std::size_t count = std::min(wishes.rows.size(), answer.solution.outcomes.size());
    for (std::size_t i = 0; i < count; ++i) {
        wishes.rows[i].found = answer.solution.outcomes[i];
    }
    wishes.found_edition = asked_wishes;
    wishes.found_version = asked_version;
    if (std::exchange(wishes.solve, false)) {
        std::vector<std::string> lines = answer.solution.commands();
        if (!lines.empty()) {
            e.run(editor::kSolveTitle, std::move(lines));
        }
        e.say(solution_words(answer.solution), now());
    }
}

// Once a turn of the loop, between frames.
void EditorWindow::State::follow_wishes() {
    EditorState& e = *editor;
    WishesShown& wishes = e.wishes;
    if (std::optional<WishSolver::Answer> answer = wish_solver.take()) {
        take_wishes(std::move(*answer));
    }
    const bool rests = !e.pace.due() && !e.pace.held() && !e.desk.waiting() && !rest_watch.busy();
    const bool due = wishes.solve || (rests && wishes.old(session.version()));
    if (!session.is_open() || session.in_gesture() || wishes.rows.empty() || !due || wish_solver.busy() ||
        e.picture.frames() == 0) {
        return;
    }
    std::vector<std::string> kept;
    for (const std::uint32_t node : wishes.kept) {
        if (editor::light_of(session.model(), node) != nullptr) {
            kept.push_back(session.path_of(node));
        }
    }
    asked_wishes = wishes.edition;
    asked_version = session.version();
    try {
        wish_solver.start(wish_task(session, e.settings, wishes.all(), kept));
        wishes.busy = true;
    } catch (const Error& error) {
        take_wishes({{}, error.what()});
    }
}

}  // namespace lanthorn::edit_window
