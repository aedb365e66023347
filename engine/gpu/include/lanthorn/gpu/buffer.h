// A GL buffer object with immutable size.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lanthorn::gpu {

class Buffer {
  public:
    Buffer() = default;
    // `bytes` of zeroed storage (at least 4 are allocated, so that an empty list still binds).
    explicit Buffer(std::size_t bytes);
    // A buffer that holds a copy of `data`, of its size.
    template <class T>
    static Buffer from(std::span<const T> data) {
        Buffer buffer(data.size_bytes());
        buffer.write(0, data);
        return buffer;
    }
    // The same of a vector.
    template <class T>
    static Buffer from(const std::vector<T>& data) {
        return from(std::span<const T>(data));
    }
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;

    GLuint id() const { return id_; }                 // GL's name; 0 of a default-constructed one
    std::uint64_t serial() const { return serial_; }  // of no other buffer, before or after
    std::size_t bytes() const { return bytes_; }      // as asked for, though never less than 4 are allocated
    explicit operator bool() const { return id_ != 0; }

    // Copies `data` to byte `offset` and after; all of it must fit, as the buffer does not grow.
    template <class T>
    void write(std::size_t offset, std::span<const T> data) {
        write_bytes(offset, data.data(), data.size_bytes());
    }
    // The same in bytes. Behind fill() on a GPU it waits for that.
    void write_bytes(std::size_t offset, const void* data, std::size_t bytes);
    // Waits for the GPU. `count` elements from byte `offset`.
    template <class T>
    std::vector<T> read(std::size_t count, std::size_t offset = 0) const {
        std::vector<T> result(count);
        read_bytes(offset, result.data(), count * sizeof(T));
        return result;
    }
    // The same as read(), in bytes, into `data`. Waits for the GPU.
    void read_bytes(std::size_t offset, void* data, std::size_t bytes) const;
    void clear() { fill(0); }        // zeroes all of it, on the GPU
    void fill(std::uint32_t value);  // every four bytes

    // Whole, for shaders' buffer blocks.
    void bind_storage(GLuint binding) const { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, id_); }
    // Whole, for uniform blocks.
    void bind_uniform(GLuint binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, id_); }

  private:
    void end_fill();

    GLuint id_ = 0;
    std::uint64_t serial_ = 0;
    std::size_t bytes_ = 0;
    bool filling_ = false;  // since the last fill() nothing has been written from here
};

// A buffer seen as a one-dimensional texture (samplerBuffer): software rasterisers read those several times
// faster than storage buffers. Follows the buffer given to bind().
class BufferTexture {
  public:
    BufferTexture() = default;
    ~BufferTexture();
    BufferTexture(const BufferTexture&) = delete;
    BufferTexture& operator=(const BufferTexture&) = delete;

    // Attaches `buffer` as texels of `internal_format` (GL_RGBA32F, GL_R32UI, ...) and binds it to a texture
    // unit.
    void bind(GLuint unit, const Buffer& buffer, GLenum internal_format);

  private:
    GLuint id_ = 0;
    std::uint64_t attached_ = 0;  // Buffer::serial(): GL gives an id again once its buffer is deleted
};

}  // namespace lanthorn::gpu
