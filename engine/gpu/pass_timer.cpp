#include "lanthorn/gpu/pass_timer.h"

#include <ctime>

#include <utility>

#include "engine/gpu/pass_end.h"

namespace lanthorn::gpu {

using std::chrono::steady_clock;

namespace {

thread_local const std::function<void()>* pass_end = nullptr;

double milliseconds(steady_clock::duration d) {
    return std::chrono::duration<double, std::milli>(d).count();
}
double processor_ms() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

// Tells at the end of a scope, whatever was done there.
struct Told {
    Told() = default;
    ~Told() { PassEnd::tell(); }
    Told(const Told&) = delete;
    Told& operator=(const Told&) = delete;
};

}  // namespace

PassEnd::PassEnd(std::function<void()> call) : call_(std::move(call)) {
    pass_end = &call_;
}

PassEnd::~PassEnd() {
    pass_end = nullptr;
}

void PassEnd::tell() {
    if (pass_end != nullptr) {
        (*pass_end)();
    }
}

bool PassEnd::is_heard() {
    return pass_end != nullptr;
}

PassTimer::~PassTimer() {
    for (const Pending& p : pending_) {
        const GLuint ids[2] = {p.begin, p.end};
        glDeleteQueries(2, ids);
    }
}

PassTimer::Scope::Scope(PassTimer& timer, std::string name) : timer_(timer), name_(std::move(name)) {
    if (!timer_.enabled_) {
        return;
    }
    if (timer_.software_) {
        glFinish();
        start_ = steady_clock::now();
        cpu_start_ = processor_ms();
    } else {
        glCreateQueries(GL_TIMESTAMP, 2, queries_);
        glQueryCounter(queries_[0], GL_TIMESTAMP);
    }
}

PassTimer::Scope::~Scope() {
    const Told told;
    if (!timer_.enabled_) {
        return;
    }
    if (timer_.software_) {
        glFinish();
        timer_.spans_.push_back({std::move(name_), milliseconds(start_ - timer_.frame_start_),
                                 milliseconds(steady_clock::now() - start_), processor_ms() - cpu_start_});
    } else {
        glQueryCounter(queries_[1], GL_TIMESTAMP);
        timer_.pending_.push_back({std::move(name_), queries_[0], queries_[1]});
    }
}

std::vector<PassTimer::Span> PassTimer::end_frame() {
    GLuint64 first = 0;
    for (const Pending& p : pending_) {
        GLuint64 begin = 0;
        GLuint64 end = 0;
        glGetQueryObjectui64v(p.begin, GL_QUERY_RESULT, &begin);
        glGetQueryObjectui64v(p.end, GL_QUERY_RESULT, &end);
        first = first == 0 ? begin : std::min(first, begin);
        spans_.push_back(
            {p.name, static_cast<double>(begin - first) * 1e-6, static_cast<double>(end - begin) * 1e-6, 0});
        const GLuint ids[2] = {p.begin, p.end};
        glDeleteQueries(2, ids);
    }
    pending_.clear();
    frame_start_ = steady_clock::now();
    return std::exchange(spans_, {});
}

}  // namespace lanthorn::gpu
