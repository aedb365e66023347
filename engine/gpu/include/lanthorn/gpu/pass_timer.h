// Time spent by pass: GL timer queries on a real GPU, the CPU clock between glFinish calls on a software
// rasteriser.
#pragma once

#include <epoxy/gl.h>

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace lanthorn::gpu {

class PassTimer {
  public:
    // Off, a pass costs nothing and is not recorded (in particular, no glFinish).
    PassTimer(bool enabled, bool software) : enabled_(enabled), software_(software) {}
    ~PassTimer();
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;

    bool enabled() const { return enabled_; }  // passes are timed

    // Times from here to the end of the scope under `name`. Passes nest; each counts its own whole.
    class Scope {
      public:
        Scope(PassTimer& timer, std::string name);
        ~Scope();
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        PassTimer& timer_;
        std::string name_;
        std::chrono::steady_clock::time_point start_;
        double cpu_start_ = 0;  // ms
        GLuint queries_[2] = {0, 0};
    };

    // A pass of a frame, milliseconds.
    struct Span {
        std::string name;
        double start_ms = 0;  // since the frame's start
        double ms = 0;
        double cpu_ms = 0;  // processor time of all threads; 0 on a real GPU
    };
    // Ends a frame: waits for the GPU and returns the frame's passes in order; those of one name are separate
    // spans.
    std::vector<Span> end_frame();

  private:
    friend class Scope;
    struct Pending {
        std::string name;
        GLuint begin = 0;
        GLuint end = 0;
    };
    std::chrono::steady_clock::time_point frame_start_ = std::chrono::steady_clock::now();
    std::vector<Span> spans_;
    std::vector<Pending> pending_;
    bool enabled_;
    bool software_;
};

}  // namespace lanthorn::gpu
