// Rays from the lit texels of one environment map, kept elsewhere (RememberedHits::kept).
#pragma once

#include "lanthorn/gpu/buffer.h"

namespace lanthorn::gi {

struct KeptRays {
    gpu::Buffer starts, flights;
    std::size_t bytes() const { return starts.bytes() + flights.bytes(); }
};

}  // namespace lanthorn::gi
