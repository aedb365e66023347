// What is called between the passes of a frame: for programs that answer their user while a long one is
// drawn.
#pragma once

#include <functional>

namespace lanthorn::gpu {

// As long as it lives, `call` is called whenever a pass that this thread draws has ended (PassTimer::Scope,
// timed or not), or a part of a long one, in the middle of the frame. It may draw into other framebuffers,
// and must leave OpenGL's state as it finds it; it must not alter what the frame is made from, and must not
// throw. One at a time.
class PassEnd {
  public:
    explicit PassEnd(std::function<void()> call);
    ~PassEnd();
    PassEnd(const PassEnd&) = delete;
    PassEnd& operator=(const PassEnd&) = delete;

    // A pass of this thread has ended, or a part of a long one.
    static void tell();
    // Somebody on this thread is told: long work that is done in parts for it alone can be done at once else.
    static bool is_heard();

  private:
    std::function<void()> call_;
};

}  // namespace lanthorn::gpu
