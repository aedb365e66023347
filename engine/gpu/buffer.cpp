#include "lanthorn/gpu/buffer.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <utility>

#include "engine/gpu/memory.h"
#include "lanthorn/gpu/context.h"

namespace lanthorn::gpu {

namespace {

std::uint64_t next_serial() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

}  // namespace

Buffer::Buffer(std::size_t bytes) : serial_(next_serial()), bytes_(std::max<std::size_t>(bytes, 4)) {
    glCreateBuffers(1, &id_);
    glNamedBufferStorage(id_, static_cast<GLsizeiptr>(bytes_), nullptr, GL_DYNAMIC_STORAGE_BIT);
    clear();
    end_fill();
    account(static_cast<std::ptrdiff_t>(bytes_));
}

Buffer::~Buffer() {
    if (id_ != 0) {
        glDeleteBuffers(1, &id_);
        account(-static_cast<std::ptrdiff_t>(bytes_));
    }
}

Buffer::Buffer(Buffer&& other) noexcept
    : id_(std::exchange(other.id_, 0)),
      serial_(std::exchange(other.serial_, 0)),
      bytes_(std::exchange(other.bytes_, 0)),
      filling_(std::exchange(other.filling_, false)) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(serial_, other.serial_);
    std::swap(bytes_, other.bytes_);
    std::swap(filling_, other.filling_);
    return *this;
}

void Buffer::write_bytes(std::size_t offset, const void* data, std::size_t bytes) {
    assert(offset + bytes <= bytes_);
    if (bytes > 0) {
        end_fill();
        glNamedBufferSubData(id_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
    }
}

void Buffer::read_bytes(std::size_t offset, void* data, std::size_t bytes) const {
    assert(offset + bytes <= bytes_);
    if (bytes > 0) {
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glGetNamedBufferSubData(id_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
    }
}

void Buffer::fill(std::uint32_t value) {
    glClearNamedBufferData(id_, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &value);
    filling_ = true;
}

// NVIDIA's driver (580.159, on an H200) writes what is small at once, without heed to a
// glClearNamedBufferData that is still under way, which then wipes it out; no barrier helps.
void Buffer::end_fill() {
    if (std::exchange(filling_, false) && !draws_in_software()) {
        glFinish();
    }
}

BufferTexture::~BufferTexture() {
    if (id_ != 0) {
        glDeleteTextures(1, &id_);
    }
}

void BufferTexture::bind(GLuint unit, const Buffer& buffer, GLenum internal_format) {
    if (id_ == 0) {
        glCreateTextures(GL_TEXTURE_BUFFER, 1, &id_);
    }
    if (attached_ != buffer.serial()) {
        glTextureBuffer(id_, internal_format, buffer.id());
        attached_ = buffer.serial();
    }
    glBindTextureUnit(unit, id_);
}

}  // namespace lanthorn::gpu
