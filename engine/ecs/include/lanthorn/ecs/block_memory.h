// Blocks of one size for tables that grow large. The first MiB comes block by block, so that a small world
// stays small; after it come slabs of 2 MiB on huge pages where the system has them, which take fewer page
// faults to fill (bench_ecs: create).
#pragma once

#include <cstddef>
#include <vector>

namespace lanthorn::ecs {

class BlockMemory {
  public:
    static constexpr std::size_t kSlabBytes = std::size_t{2} << 20;
    static constexpr std::size_t kAlign = 64;

    // `block_bytes`: a power of two, at least kAlign and at most kSlabBytes.
    explicit BlockMemory(std::size_t block_bytes) : block_bytes_(block_bytes) {}
    BlockMemory(const BlockMemory&) = delete;
    BlockMemory& operator=(const BlockMemory&) = delete;
    BlockMemory(BlockMemory&& o) noexcept;
    BlockMemory& operator=(BlockMemory&& o) noexcept;
    ~BlockMemory() { clear(); }

    // Raw memory that holds until clear() or the end of this. O(1); throws std::bad_alloc.
    std::byte* take();
    // Gives a block's pages back to the system; its address stays valid, its bytes are lost.
    void discard(std::byte* block) noexcept;
    // Frees every block, given back or not; no address that take() gave is valid any more.
    void clear() noexcept;

  private:
    std::size_t block_bytes_;
    std::vector<std::byte*> singles_, slabs_;
    std::size_t used_in_slab_ = kSlabBytes;  // bytes of the last slab that were given out
};

}  // namespace lanthorn::ecs
