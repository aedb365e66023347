#include "lanthorn/ecs/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <optional>

namespace lanthorn::ecs::detail {

void run_parallel_for(std::size_t count, Task task) {
    tbb::parallel_for(std::size_t{0}, count, [task](std::size_t i) { task.run(task.context, i); });
}

struct Workers::Impl {
    std::optional<tbb::task_arena> arena;
    tbb::task_group* group = nullptr;
    Task task{};
};

Workers::Workers(int threads) : threads_(threads), impl_(std::make_unique<Impl>()) {
    if (threads > 0) impl_->arena.emplace(threads);
}

Workers::~Workers() = default;

void Workers::spawn_raw(std::size_t i) {
    impl_->group->run([task = impl_->task, i] { task.run(task.context, i); });
}

void Workers::run_raw(std::span<const std::size_t> first, Task task) {
    const auto work = [&] {
        tbb::task_group group;
        impl_->group = &group;
        impl_->task = task;
        for (const std::size_t i : first) spawn_raw(i);
        group.wait();
        impl_->group = nullptr;
    };
    if (impl_->arena) {
        impl_->arena->execute(work);
    } else {
        work();
    }
}

}  // namespace lanthorn::ecs::detail
