#include "gi_module/reference/tile_workers.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace lanthorn::reference {

namespace {

int thread_count(int wanted) {
    const int cores = tbb::info::default_concurrency();
    return wanted > 0 ? std::min(wanted, cores) : cores;
}

}  // namespace

struct TileWorkers::Impl {
    tbb::task_arena arena;
};

TileWorkers::TileWorkers(int threads) : impl_(new Impl{tbb::task_arena(thread_count(threads))}) {}
TileWorkers::~TileWorkers() = default;

void TileWorkers::run_raw(std::size_t count, ecs::detail::Task task) {
    impl_->arena.execute([&] {
        tbb::parallel_for(
            std::size_t{0}, count, [task](std::size_t i) { task.run(task.context, i); },
            tbb::simple_partitioner());
    });
}

}  // namespace lanthorn::reference
