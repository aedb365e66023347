#include "tools/replay_suite/local_executor.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "tools/replay_suite/worker.h"

namespace lanthorn::suite {

void run_locally(const Plan& plan, const std::vector<std::size_t>& which, const ResultFiles& files, int jobs,
                 const OnResult& on_result, const std::function<bool()>& stop) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    std::mutex mutex;  // of what follows
    std::size_t done = 0;
    std::exception_ptr error;
    const Worker worker(plan, files.folder() / "scratch", [&] { return stop() || failed.load(); });
    const auto work = [&] {
        try {
            for (std::size_t at; (at = next.fetch_add(1)) < which.size() && !stop() && !failed;) {
                const Item& item = plan.items[which[at]];
                if (!files.find(item.key)) {
                    const std::optional<Result> result = worker.judge(item);
                    if (!result) {
                        return;
                    }
                    files.put(*result);
                }
                const std::lock_guard lock(mutex);
                on_result(++done);
            }
        } catch (...) {
            failed = true;
            const std::lock_guard lock(mutex);
            error = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < jobs; ++i) {
            threads.emplace_back(work);
        }
    }
    if (error) {
        std::rethrow_exception(error);
    }
}

}  // namespace lanthorn::suite
