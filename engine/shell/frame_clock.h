// How long the machine works for a frame, without what it waits for the screen.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <chrono>

namespace lanthorn::shell {

class FrameClock {
  public:
    // The OpenGL context must be current, for the destructor too. `software`: OpenGL runs on the CPU, where
    // its clock means nothing: all of a frame counts.
    explicit FrameClock(bool software) : software_(software) {}
    ~FrameClock();
    FrameClock(const FrameClock&) = delete;
    FrameClock& operator=(const FrameClock&) = delete;

    // Around the work of a frame, before the buffers are swapped.
    void begin();
    void end();

    // Of the newest frame that the GPU has finished, the longer of its time and the processor's,
    // milliseconds; never waits. `frame_ms`, where nothing is known better.
    double busy(double frame_ms);

  private:
    struct Pair {
        GLuint begin = 0, end = 0;
        double cpu_ms = 0;
        bool waits = false;
    };
    bool software_;
    std::array<Pair, 4> pairs_{};
    std::size_t at_ = 0;
    std::chrono::steady_clock::time_point begun_;
    double newest_ = 0;
};

}  // namespace lanthorn::shell
