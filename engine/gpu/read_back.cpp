#include "engine/gpu/read_back.h"

#include <cassert>
#include <utility>

#include "engine/gpu/memory.h"

namespace lanthorn::gpu {

ReadBack::~ReadBack() {
    for (Slot& slot : slots_) {
        release(slot);
    }
}

void ReadBack::release(Slot& slot) {
    if (slot.fence != nullptr) {
        glDeleteSync(std::exchange(slot.fence, nullptr));
    }
    if (slot.buffer != 0) {
        glDeleteBuffers(1, &slot.buffer);  // unmaps it
        account(-static_cast<std::ptrdiff_t>(slot.capacity));
        slot = {};
    }
}

void ReadBack::allocate(Slot& slot, std::size_t bytes) {
    if (slot.capacity >= bytes) {
        return;
    }
    release(slot);
    constexpr GLbitfield kAccess = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    const auto size = static_cast<GLsizeiptr>(bytes);
    glCreateBuffers(1, &slot.buffer);
    glNamedBufferStorage(slot.buffer, size, nullptr, kAccess | GL_CLIENT_STORAGE_BIT);
    slot.mapped = static_cast<const std::byte*>(glMapNamedBufferRange(slot.buffer, 0, size, kAccess));
    slot.capacity = bytes;
    account(static_cast<std::ptrdiff_t>(bytes));
}

void ReadBack::reserve(std::size_t bytes) {
    assert(count_ == 0);
    for (Slot& slot : slots_) {
        allocate(slot, bytes);
    }
}

void ReadBack::begin(const Buffer& from, std::size_t bytes, std::uint64_t tag) {
    assert(!full() && bytes <= from.bytes());
    Slot& slot = slots_[(first_ + count_++) % kSlots];
    allocate(slot, bytes);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glCopyNamedBufferSubData(from.id(), slot.buffer, 0, 0, static_cast<GLsizeiptr>(bytes));
    slot.fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    slot.bytes = bytes;
    slot.tag = tag;
}

std::optional<ReadBack::Arrived> ReadBack::take(GLuint64 nanoseconds) {
    if (count_ == 0) {
        return std::nullopt;
    }
    Slot& slot = slots_[first_];
    const GLenum state = glClientWaitSync(slot.fence, GL_SYNC_FLUSH_COMMANDS_BIT, nanoseconds);
    if (state == GL_TIMEOUT_EXPIRED) {
        return std::nullopt;
    }
    glDeleteSync(std::exchange(slot.fence, nullptr));
    first_ = (first_ + 1) % kSlots;
    --count_;
    return Arrived{slot.tag, {slot.mapped, slot.mapped + slot.bytes}};
}

std::optional<ReadBack::Arrived> ReadBack::wait() {
    return take(~GLuint64{0});
}

}  // namespace lanthorn::gpu
