#include "tools/replay_suite/local_executor.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "tools/replay_suite/worker.h"

namespace lanthorn::suite {

void work_through(std::size_t count, int jobs, const std::function<bool()>& stop,
                  const std::function<bool(std::size_t, const std::function<bool()>&)>& item) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    std::mutex mutex;  // of `error`
    std::exception_ptr error;
    const std::function<bool()> over = [&] { return stop() || failed.load(); };
    const auto work = [&] {
        try {
            for (std::size_t at; (at = next.fetch_add(1)) < count && !over();) {
                if (!item(at, over)) {
                    return;
                }
            }
        } catch (...) {
            failed = true;
            const std::lock_guard lock(mutex);
            error = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> threads;
        threads.reserve(static_cast<std::size_t>(jobs));
        for (int i = 0; i < jobs; ++i) {
            threads.emplace_back(work);
        }
    }
    if (error) {
        std::rethrow_exception(error);
    }
}

void run_locally(const Plan& plan, const std::vector<std::size_t>& which, const ResultFiles& files, int jobs,
                 const OnResult& on_result, const std::function<bool()>& stop) {
    std::mutex mutex;  // of `done`
    std::size_t done = 0;
    work_through(which.size(), jobs, stop, [&](std::size_t at, const std::function<bool()>& over) {
        const Item& item = plan.items[which[at]];
        if (!files.find(item.key)) {
            const std::optional<Result> result = Worker(plan, files.folder() / "scratch", over).judge(item);
            if (!result) {
                return false;
            }
            files.put(*result);
        }
        const std::lock_guard lock(mutex);
        on_result(++done);
        return true;
    });
}

}  // namespace lanthorn::suite
