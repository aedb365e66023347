// A list of numbers that shaders make and work off. The GLSL side: entry_list.glsl.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/gpu/buffer.h"

namespace lanthorn::gi {

class EntryList {
  public:
    // Room for so many; there is none yet.
    void resize(std::size_t capacity);
    void clear();

    void bind_storage(GLuint binding) const { buffer_.bind_storage(binding); }
    // Of the program in use: the invocations that each entry was listed with, 256 a group.
    void dispatch() const;

    explicit operator bool() const { return static_cast<bool>(buffer_); }
    std::uint32_t count() const;              // waits for the GPU
    std::vector<std::uint32_t> read() const;  // all of it; waits for the GPU
    // Into the word of another buffer at byte `offset`, as of now, without waiting.
    void copy_count(const gpu::Buffer& to, std::size_t offset = 0) const;
    std::size_t bytes() const { return buffer_.bytes(); }

  private:
    gpu::Buffer buffer_;
};

}  // namespace lanthorn::gi
