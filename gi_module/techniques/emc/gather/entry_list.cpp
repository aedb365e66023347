#include "gi_module/techniques/emc/gather/entry_list.h"

namespace lanthorn::gi {

namespace {

constexpr std::uint32_t kHeader[4] = {0, 0, 1, 1};  // none; groups x, y, z

}  // namespace

void EntryList::resize(std::size_t capacity) {
    buffer_ = gpu::Buffer(sizeof(kHeader) + capacity * sizeof(std::uint32_t));
    clear();
}

void EntryList::clear() {
    buffer_.write_bytes(0, kHeader, sizeof(kHeader));
}

void EntryList::dispatch() const {
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, buffer_.id());
    glDispatchComputeIndirect(sizeof(std::uint32_t));
}

void EntryList::copy_count(const gpu::Buffer& to, std::size_t offset) const {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glCopyNamedBufferSubData(buffer_.id(), to.id(), 0, static_cast<GLintptr>(offset), sizeof(std::uint32_t));
}

std::uint32_t EntryList::count() const {
    if (!buffer_) {
        return 0;
    }
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    return buffer_.read<std::uint32_t>(1).front();
}

std::vector<std::uint32_t> EntryList::read() const {
    const std::uint32_t listed = count();
    return listed > 0 ? buffer_.read<std::uint32_t>(listed, sizeof(kHeader)) : std::vector<std::uint32_t>();
}

}  // namespace lanthorn::gi
