// Runs one item of a plan in processes of its own and says what became of it. The same for every executor.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "tools/replay_suite/limited_child.h"
#include "tools/replay_suite/plan.h"
#include "tools/replay_suite/result.h"

namespace lanthorn::suite {

class Worker {
  public:
    // What is made on the way lies below `scratch` and is removed. `stop` ends a run that goes on.
    Worker(const Plan& plan, std::filesystem::path scratch, std::function<bool()> stop);

    // Runs `replay verify`; a failure a second time, which says whether it is the same in every run: one that
    // is not is flaky, and a failure all the same. What the machine did (no process, no OpenGL) is tried
    // twice and then not judged. None if it was stopped. From several threads.
    std::optional<Result> judge(const Item& item) const;

  private:
    struct Attempt;
    Attempt attempt(const Item& item, int run) const;

    const Plan& plan_;
    std::filesystem::path scratch_;
    std::function<bool()> stop_;
};

}  // namespace lanthorn::suite
