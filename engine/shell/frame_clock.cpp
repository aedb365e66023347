#include "engine/shell/frame_clock.h"

#include <algorithm>

namespace lanthorn::shell {

FrameClock::~FrameClock() {
    for (const Pair& pair : pairs_) {
        const GLuint names[] = {pair.begin, pair.end};
        glDeleteQueries(2, names);  // 0 is no matter
    }
}

void FrameClock::begin() {
    begun_ = std::chrono::steady_clock::now();
    if (software_) {
        return;
    }
    Pair& pair = pairs_[at_];
    if (pair.begin == 0) {
        glCreateQueries(GL_TIMESTAMP, 1, &pair.begin);
        glCreateQueries(GL_TIMESTAMP, 1, &pair.end);
    }
    pair.waits = false;  // four frames old: nobody will ask for it
    glQueryCounter(pair.begin, GL_TIMESTAMP);
}

void FrameClock::end() {
    if (software_) {
        return;
    }
    Pair& pair = pairs_[at_];
    glQueryCounter(pair.end, GL_TIMESTAMP);
    pair.cpu_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun_).count();
    pair.waits = true;
    at_ = (at_ + 1) % pairs_.size();
}

double FrameClock::busy(double frame_ms) {
    // The oldest first.
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        Pair& pair = pairs_[(at_ + i) % pairs_.size()];
        if (!pair.waits) {
            continue;
        }
        GLuint there = GL_FALSE;
        glGetQueryObjectuiv(pair.end, GL_QUERY_RESULT_AVAILABLE, &there);
        if (there == GL_FALSE) {
            break;
        }
        GLuint64 first = 0, last = 0;
        glGetQueryObjectui64v(pair.begin, GL_QUERY_RESULT, &first);
        glGetQueryObjectui64v(pair.end, GL_QUERY_RESULT, &last);
        newest_ = std::max(pair.cpu_ms, 1e-6 * static_cast<double>(last - first));
        pair.waits = false;
    }
    return newest_ > 0 ? std::min(newest_, frame_ms) : frame_ms;
}

}  // namespace lanthorn::shell
