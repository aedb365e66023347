#include "tools/editor/window/wish_solver.h"

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <exception>
#include <utility>

namespace lanthorn::edit_window {

void WishSolver::start(editor::WishTask task) {
    answer_ = std::async(std::launch::async, [task = std::move(task), ready = ready_] {
        ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 10);  // of this thread alone
        Answer answer;
        try {
            answer.solution = editor::solve_wishes(task);
        } catch (const std::exception& error) {
            answer.problem = error.what();
        }
        ready();
        return answer;
    });
}

std::optional<WishSolver::Answer> WishSolver::take() {
    if (!busy() || answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        return std::nullopt;
    }
    return answer_.get();
}

}  // namespace lanthorn::edit_window
