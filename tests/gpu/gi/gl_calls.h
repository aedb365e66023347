// Which calls of OpenGL frames make: those that make the processor wait for the GPU, and those that allocate.
#pragma once

#include <map>
#include <string>

namespace lanthorn::gi::test {

// Counts while it lives, of all contexts. One at a time.
class GlCalls {
  public:
    GlCalls();
    ~GlCalls();
    GlCalls(const GlCalls&) = delete;
    GlCalls& operator=(const GlCalls&) = delete;

    // By name of the function. Waiting for a fence counts if it was set since the last call of next_frame():
    // what an earlier frame has given the GPU to do need not hold up this one's.
    using Counts = std::map<std::string, int>;
    const Counts& waits() const;
    const Counts& allocations() const;
    // Nothing is counted yet, and all fences so far are of earlier frames.
    void next_frame();
};

}  // namespace lanthorn::gi::test
