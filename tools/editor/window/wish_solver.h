// Light wishes, solved or looked at on a thread of their own.
#pragma once

#include <functional>
#include <future>
#include <optional>
#include <string>

#include "tools/editor/core/light_wishes.h"

namespace lanthorn::edit_window {

class WishSolver {
  public:
    // `ready` is called from the other thread once take() has something; it must not block.
    explicit WishSolver(std::function<void()> ready) : ready_(std::move(ready)) {}

    struct Answer {
        editor::WishSolution solution;
        std::string problem;  // one line; empty: none
    };
    // One at a time: not while busy(). The thread has a low priority.
    void start(editor::WishTask task);
    bool busy() const { return answer_.valid(); }
    std::optional<Answer> take();  // nothing: not yet

  private:
    std::function<void()> ready_;
    std::future<Answer> answer_;
};

}  // namespace lanthorn::edit_window
