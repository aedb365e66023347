#include "engine/deformation/frame_pool.h"

namespace lanthorn::deform {

std::shared_ptr<std::vector<VertexFrame>> FramePool::take(std::size_t vertices) {
    for (auto& array : arrays_) {
        if (array.use_count() != 1) {
            continue;
        }
        // Whoever let go of it last, perhaps another thread, has read it: to hold it first orders what is
        // written from here on after that. (A fence would too, but the thread sanitizer knows none.)
        auto held = array;
        if (held->size() != vertices) {
            held->resize(vertices);
        }
        return held;
    }
    return arrays_.emplace_back(std::make_shared<std::vector<VertexFrame>>(vertices));
}

}  // namespace lanthorn::deform
