// Where each of many lists begins that lie one after another: the sum of the counts before. Blocks of counts
// are added up side by side, then each block adds to what the blocks before it have (Blelloch 1990, "Prefix
// sums and their applications", sec. 1.3).
#pragma once

#include <cstddef>

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

class PrefixSums {
  public:
    // Room for so many counts. What was summed before is gone.
    void resize(std::size_t count);
    // Of `counts`, uint32 each, as many as there is room for. Writes are visible to what follows.
    void add_up(const gpu::Buffer& counts);
    const gpu::Buffer& sums() const { return sums_; }  // uint32 each: of the counts before
    std::size_t bytes() const { return sums_.bytes() + blocks_.bytes(); }

  private:
    std::size_t count_ = 0;
    gpu::Program add_blocks_, add_up_;
    gpu::Buffer sums_;
    gpu::Buffer blocks_;  // uint32: of each block
    gpu::BufferTexture counts_view_, blocks_view_;
};

}  // namespace lanthorn::gi
