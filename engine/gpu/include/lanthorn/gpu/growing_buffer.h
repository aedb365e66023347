// A buffer for what differs from use to use, and in size: it grows, and is never recreated otherwise.
#pragma once

#include <span>

#include "lanthorn/gpu/buffer.h"

namespace lanthorn::gpu {

class GrowingBuffer {
  public:
    // What it holds from here on; what follows, up to its own size, is of earlier uses. Half as much room
    // again is made where there was too little.
    template <class T>
    const Buffer& hold(std::span<const T> data) {
        if (!buffer_ || buffer_.bytes() < data.size_bytes()) {
            buffer_ = Buffer(data.size_bytes() + data.size_bytes() / 2);
        }
        buffer_.write(0, data);
        return buffer_;
    }
    // What was held last, and unused room behind it. Without storage before the first hold().
    const Buffer& buffer() const { return buffer_; }
    explicit operator bool() const { return static_cast<bool>(buffer_); }  // has held something

  private:
    Buffer buffer_;
};

}  // namespace lanthorn::gpu
