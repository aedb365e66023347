#include "engine/deformation/frame_pool.h"

#include <atomic>

namespace lanthorn::deform {

std::shared_ptr<std::vector<VertexFrame>> FramePool::take(std::size_t vertices) {
    for (auto& array : arrays_) {
        if (array.use_count() != 1) continue;
        // Whoever let go of it last, perhaps another thread, has read it.
        std::atomic_thread_fence(std::memory_order_acquire);
        if (array->size() != vertices) array->resize(vertices);
        return array;
    }
    return arrays_.emplace_back(std::make_shared<std::vector<VertexFrame>>(vertices));
}

}  // namespace lanthorn::deform
