// oneTBB behind two plain calls. Kept in its own source file, because oneTBB is not built with the thread
// sanitizer: that file is not either, and its synchronisation is declared to the sanitizer here.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>

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

// How many bodies of Query::parallel_each this thread is in. What is no single thread's cannot be asked for
// there.
inline constinit thread_local int parallel_each_depth = 0;

struct InParallelEach {
    InParallelEach() { ++parallel_each_depth; }
    InParallelEach(const InParallelEach&) = delete;
    InParallelEach& operator=(const InParallelEach&) = delete;
    ~InParallelEach() { --parallel_each_depth; }
};

[[noreturn]] void throw_in_parallel_each(std::string_view action);

// Throws an Error if called from a body of Query::parallel_each.
inline void check_not_in_parallel_each(std::string_view action) {
    if (parallel_each_depth != 0) {
        throw_in_parallel_each(action);
    }
}

void run_parallel_for(std::size_t count, Task task);

// While one exists on a thread, parallel_for on that thread runs everything there.
class OnThisThread {
  public:
    OnThisThread();
    OnThisThread(const OnThisThread&) = delete;
    OnThisThread& operator=(const OnThisThread&) = delete;
    ~OnThisThread();

  private:
    bool before_;
};

// body(i) for i = 0 .. count-1, in any order, several at once. Exceptions come out. A thread that waits for
// the others takes no work but this call's, so that nothing else runs on its stack.
template <class Body>
void parallel_for(std::size_t count, Body&& body) {
    struct Context {
        Body& body;
        char start = 0, end = 0;
    } context{body};
    happens_before(&context.start);
    // Told on the way out of an exception too.
    struct Ended {
        char& end;
        ~Ended() { happens_before(&end); }
    };
    struct AllEnded {
        char& end;
        ~AllEnded() { happens_after(&end); }
    } const all_ended{context.end};
    run_parallel_for(count, {[](void* c, std::size_t i) {
                                 auto& own = *static_cast<Context*>(c);
                                 happens_after(&own.start);
                                 const Ended ended{own.end};
                                 own.body(i);
                             },
                             &context});
}

// Runs numbered tasks that start one another; some of them only on the thread that called run().
class Workers {
  public:
    // 0: as many threads as oneTBB has; never more than those.
    explicit Workers(int threads);
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers();
    int threads() const { return threads_; }

    // Calls fn() on the calling thread, with these workers as helpers of what it runs in parallel.
    template <class Fn>
    void lead(Fn&& fn) {
        lead_raw({[](void* c, std::size_t) { (*static_cast<std::remove_reference_t<Fn>*>(c))(); }, &fn});
    }

    // Runs body(i) for each i of `first` and all that spawn() and spawn_on_caller() add meanwhile, each
    // number below `count`, at most once; returns when all are done. body must not throw. `on_caller`: the
    // numbers that will be given to spawn_on_caller(), every one of them, in an order that they allow: none
    // of them waits for a later one. They run in this order on the calling thread, which meanwhile helps with
    // the others.
    template <class Body>
    void run(std::size_t count, std::span<const std::size_t> first, std::span<const std::size_t> on_caller,
             Body&& body) {
        struct Context {
            Workers& workers;
            Body& body;
            char end = 0;
        } context{*this, body};
        tokens_ = std::make_unique<char[]>(count);
        happens_before(&context);
        run_raw(first, on_caller,
                {[](void* c, std::size_t i) {
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
    void spawn_on_caller(std::size_t i) {
        happens_before(&tokens_[i]);
        spawn_on_caller_raw(i);
    }

  private:
    struct Impl;
    void lead_raw(Task task);
    void run_raw(std::span<const std::size_t> first, std::span<const std::size_t> on_caller, Task task);
    void spawn_raw(std::size_t i);
    void spawn_on_caller_raw(std::size_t i);

    int threads_;
    std::unique_ptr<char[]> tokens_;
    std::unique_ptr<Impl> impl_;
};

}  // namespace lanthorn::ecs::detail
