// oneTBB behind two plain calls. It stands apart in one source file for the thread sanitizer's sake: the
// library is not built with it, so that file is not either, and what synchronises with what is told here
// instead.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace lanthorn::ecs::detail {

#if defined(__SANITIZE_THREAD__)
inline void happens_before(void* at) {
    __tsan_release(at);
}
inline void happens_after(void* at) {
    __tsan_acquire(at);
}
#else
inline void happens_before(void*) {}
inline void happens_after(void*) {}
#endif

struct Task {
    void (*run)(void* context, std::size_t index);
    void* context;
};

void run_parallel_for(std::size_t count, Task task);

// body(i) for i = 0 .. count-1, in any order, several at once. Exceptions come out.
template <class Body>
void parallel_for(std::size_t count, Body&& body) {
    struct Context {
        Body& body;
        char start = 0, end = 0;
    } context{body};
    happens_before(&context.start);
    run_parallel_for(count, {[](void* c, std::size_t i) {
                                 auto& own = *static_cast<Context*>(c);
                                 happens_after(&own.start);
                                 own.body(i);
                                 happens_before(&own.end);
                             },
                             &context});
    happens_after(&context.end);
}

// Runs numbered tasks that start one another.
class Workers {
  public:
    // 0: as many threads as oneTBB has.
    explicit Workers(int threads);
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers();
    int threads() const { return threads_; }

    // Runs body(i) for each i of `first` and all that spawn() adds meanwhile, each number below `count`, at
    // most once; returns when all are done. body must not throw.
    template <class Body>
    void run(std::size_t count, std::span<const std::size_t> first, Body&& body) {
        struct Context {
            Workers& workers;
            Body& body;
            char end = 0;
        } context{*this, body};
        tokens_ = std::make_unique<char[]>(count);
        happens_before(&context);
        run_raw(first, {[](void* c, std::size_t i) {
                            happens_after(c);
                            auto& own = *static_cast<Context*>(c);
                            happens_after(&own.workers.tokens_[i]);
                            own.body(i);
                            happens_before(&own.end);
                        },
                        &context});
        happens_after(&context.end);
    }
    // From inside a body.
    void spawn(std::size_t i) {
        happens_before(&tokens_[i]);
        spawn_raw(i);
    }

  private:
    struct Impl;
    void run_raw(std::span<const std::size_t> first, Task task);
    void spawn_raw(std::size_t i);

    int threads_;
    std::unique_ptr<char[]> tokens_;
    std::unique_ptr<Impl> impl_;
};

}  // namespace lanthorn::ecs::detail
