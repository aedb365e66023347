// What the GPU has computed, back on the CPU some frames later, without waiting for it.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lanthorn/gpu/buffer.h"

namespace lanthorn::gpu {

// A ring of buffers that the GPU copies into and the CPU has mapped, each with a fence. Needs its context for
// as long as it lives.
class ReadBack {
  public:
    ReadBack() = default;
    ~ReadBack();
    ReadBack(const ReadBack&) = delete;
    ReadBack& operator=(const ReadBack&) = delete;

    static constexpr std::size_t kSlots = 4;

    // Whether begin() has a free buffer. More than kSlots copies are never under way.
    bool full() const { return count_ == kSlots; }
    // Room for copies of so many bytes, so that none allocates. None is under way.
    void reserve(std::size_t bytes);
    // Copies the first `bytes` of `from`, as the GPU has them when it comes to that. `tag` comes back with
    // them. Not while full().
    void begin(const Buffer& from, std::size_t bytes, std::uint64_t tag);

    struct Arrived {
        std::uint64_t tag = 0;
        std::vector<std::byte> bytes;
    };
    // The oldest copy that has come and was not taken; nothing while the GPU works on it. Never waits.
    std::optional<Arrived> take() { return take(0); }
    // The same, but waits for the oldest copy; nothing only if none is under way: at
    // best taken a frame later, when the GPU is done with it.
    std::optional<Arrived> wait();

  private:
    struct Slot {
        GLuint buffer = 0;
        const std::byte* mapped = nullptr;
        std::size_t capacity = 0, bytes = 0;
        GLsync fence = nullptr;
        std::uint64_t tag = 0;
    };

    std::optional<Arrived> take(GLuint64 nanoseconds);
    static void allocate(Slot& slot, std::size_t bytes);
    static void release(Slot& slot);

    std::array<Slot, kSlots> slots_;
    std::size_t first_ = 0, count_ = 0;  // under way, oldest first
};

}  // namespace lanthorn::gpu
