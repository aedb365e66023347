#include "lanthorn/ecs/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <iterator>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/ecs/error.h"

namespace lanthorn::ecs::detail {
namespace {

thread_local bool on_this_thread = false;

}  // namespace

void throw_in_parallel_each(std::string_view action) {
    throw Error("cannot " + std::string(action) +
                " inside parallel_each, whose order is not known; note in a component what is to be done and "
                "do it in each()");
}

OnThisThread::OnThisThread() : before_(on_this_thread) {
    on_this_thread = true;
}

OnThisThread::~OnThisThread() {
    on_this_thread = before_;
}

void run_parallel_for(std::size_t count, Task task) {
    if (on_this_thread || count < 2) {
        for (std::size_t i = 0; i < count; ++i) {
            task.run(task.context, i);
        }
        return;
    }
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(std::size_t{0}, count, [task](std::size_t i) { task.run(task.context, i); });
    });
}

struct Workers::Impl {
    std::optional<tbb::task_arena> arena;
    tbb::task_group* group = nullptr;
    Task task{};

    // What the caller may run by now. It sleeps in `gate`, helping others, until `wake` is run.
    std::mutex mutex;
    std::vector<std::size_t> for_caller;
    tbb::task_group* gate = nullptr;
    tbb::task_handle wake;
    std::size_t awaited = 0;  // where there is a `wake`

    void wait_for(std::size_t i);
};

Workers::Workers(int threads) : threads_(threads), impl_(std::make_unique<Impl>()) {
    if (threads > 0) {
        // oneTBB says on standard error that it leaves out those beyond.
        const std::size_t most =
            tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
        impl_->arena.emplace(static_cast<int>(std::min(static_cast<std::size_t>(threads), most)));
    }
}

Workers::~Workers() = default;

void Workers::lead_raw(Task task) {
    if (impl_->arena) {
        impl_->arena->execute([&] { task.run(task.context, 0); });
    } else {
        task.run(task.context, 0);
    }
}

void Workers::spawn_raw(std::size_t i) {
    impl_->group->run([task = impl_->task, i] { task.run(task.context, i); });
}

void Workers::spawn_on_caller_raw(std::size_t i) {
    const std::lock_guard lock(impl_->mutex);
    impl_->for_caller.push_back(i);
    if (impl_->wake && impl_->awaited == i) {
        impl_->gate->run(std::move(impl_->wake));
    }
}

// Until spawn_on_caller(i) was called.
void Workers::Impl::wait_for(std::size_t i) {
    {
        const std::lock_guard lock(mutex);
        if (std::find(for_caller.begin(), for_caller.end(), i) != for_caller.end()) {
            return;
        }
        awaited = i;
        wake = gate->defer([] {});
    }
    gate->wait();
}

void Workers::run_raw(std::span<const std::size_t> first, std::span<const std::size_t> on_caller, Task task) {
    tbb::task_group group;
    tbb::task_group gate;
    impl_->group = &group;
    impl_->gate = &gate;
    impl_->task = task;
    const auto waits_for_caller = [&](std::size_t i) {
        return std::find(on_caller.begin(), on_caller.end(), i) != on_caller.end();
    };
    {  // before anything is spawned: from then on others add to the list
        const std::lock_guard lock(impl_->mutex);
        impl_->for_caller.clear();
        std::copy_if(first.begin(), first.end(), std::back_inserter(impl_->for_caller), waits_for_caller);
    }
    for (const std::size_t i : first) {
        if (!waits_for_caller(i)) {
            spawn_raw(i);
        }
    }
    for (const std::size_t i : on_caller) {
        impl_->wait_for(i);
        task.run(task.context, i);
    }
    group.wait();
    impl_->group = nullptr;
    impl_->gate = nullptr;
}

}  // namespace lanthorn::ecs::detail
