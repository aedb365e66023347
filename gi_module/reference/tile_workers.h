// Threads that share a picture's tiles. oneTBB stands apart in one source file for the thread sanitizer's
// sake, as in engine/ecs/include/lanthorn/ecs/parallel.h, whose means are used here.
#pragma once

#include <cstddef>
#include <memory>

#include "lanthorn/ecs/parallel.h"

namespace lanthorn::reference {

class TileWorkers {
  public:
    // No more threads than there are cores; 0: as many.
    explicit TileWorkers(int threads);
    ~TileWorkers();
    TileWorkers(const TileWorkers&) = delete;
    TileWorkers& operator=(const TileWorkers&) = delete;

    // body(i) for i = 0 .. count-1, in any order, several at once. Exceptions come out.
    template <class Body>
    void run(std::size_t count, const Body& body) {
        struct Context {
            const Body& body;
            char start = 0, end = 0;
        } context{body};
        ecs::detail::happens_before(&context.start);
        run_raw(count, {[](void* c, std::size_t i) {
                            auto& own = *static_cast<Context*>(c);
                            ecs::detail::happens_after(&own.start);
                            own.body(i);
                            ecs::detail::happens_before(&own.end);
                        },
                        &context});
        ecs::detail::happens_after(&context.end);
    }

  private:
    struct Impl;
    void run_raw(std::size_t count, ecs::detail::Task task);

    std::unique_ptr<Impl> impl_;
};

}  // namespace lanthorn::reference
