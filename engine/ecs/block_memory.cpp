#include "lanthorn/ecs/block_memory.h"

#include <sys/mman.h>

#include <new>
#include <utility>

namespace lanthorn::ecs {
namespace {

constexpr std::size_t kSingleBytes = std::size_t{1} << 20;  // before the first slab
constexpr std::size_t kPageBytes = 4096;

}  // namespace

BlockMemory::BlockMemory(BlockMemory&& o) noexcept
    : block_bytes_(o.block_bytes_),
      singles_(std::move(o.singles_)),
      slabs_(std::move(o.slabs_)),
      used_in_slab_(std::exchange(o.used_in_slab_, kSlabBytes)) {
    o.singles_.clear();
    o.slabs_.clear();
}

BlockMemory& BlockMemory::operator=(BlockMemory&& o) noexcept {
    if (this != &o) {
        clear();
        block_bytes_ = o.block_bytes_;
        std::swap(singles_, o.singles_);
        std::swap(slabs_, o.slabs_);
        std::swap(used_in_slab_, o.used_in_slab_);
    }
    return *this;
}

std::byte* BlockMemory::take() {
    if (singles_.size() * block_bytes_ < kSingleBytes) {
        singles_.reserve(singles_.size() + 1);
        singles_.push_back(static_cast<std::byte*>(::operator new (block_bytes_, std::align_val_t{kAlign})));
        return singles_.back();
    }
    if (used_in_slab_ == kSlabBytes) {
        slabs_.reserve(slabs_.size() + 1);
        auto* slab = static_cast<std::byte*>(::operator new (kSlabBytes, std::align_val_t{kSlabBytes}));
        ::madvise(slab, kSlabBytes, MADV_HUGEPAGE);  // a wish: without huge pages it works as well
        slabs_.push_back(slab);
        used_in_slab_ = 0;
    }
    std::byte* block = slabs_.back() + used_in_slab_;
    used_in_slab_ += block_bytes_;
    return block;
}

void BlockMemory::discard(std::byte* block) noexcept {
    // Pages that other memory shares stay.
    const std::size_t before = (kPageBytes - reinterpret_cast<std::size_t>(block) % kPageBytes) % kPageBytes;
    if (before < block_bytes_) {
        const std::size_t pages = (block_bytes_ - before) / kPageBytes;
        ::madvise(block + before, pages * kPageBytes, MADV_DONTNEED);
    }
}

void BlockMemory::clear() noexcept {
    for (std::byte* block : singles_) {
        ::operator delete (block, std::align_val_t{kAlign});
    }
    for (std::byte* slab : slabs_) {
        ::operator delete (slab, std::align_val_t{kSlabBytes});
    }
    singles_.clear();
    slabs_.clear();
    used_in_slab_ = kSlabBytes;
}

}  // namespace lanthorn::ecs
