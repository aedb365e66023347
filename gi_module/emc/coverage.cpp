#include "lanthorn/gi/emc/coverage.h"

#include <algorithm>

namespace lanthorn::gi {

CoverageMeter::CoverageMeter() : program_({"gi_module/emc/coverage.comp"}) {}

void CoverageMeter::place(const std::vector<vec3>& centres) {
    const int count = static_cast<int>(centres.size());
    if (!maps_ || maps_->maps().slots() != count) {
        maps_.emplace(MapUse::coverage, count, kCoverageResolution);
        placed_.clear();
    }
    if (placed_ != centres) {
        std::vector<vec4> padded;
        for (int i = 0; i < count; ++i) {
            maps_->place(i, centres[static_cast<std::size_t>(i)]);
            padded.emplace_back(centres[static_cast<std::size_t>(i)], 0.0f);
        }
        centres_ = gpu::Buffer::from(padded);
        placed_ = centres;
    }
}

void CoverageMeter::draw(const FrameScene& scene, const render::GpuScene& gpu_scene,
                         const std::vector<int>& candidates, int look) {
    maps_->update(scene, gpu_scene, candidates, look);
}

std::vector<Coverage> CoverageMeter::measure(const std::vector<int>& viewers,
                                             const std::vector<int>& selected) {
    constexpr int kGroups = 6 * kCoverageResolution * kCoverageResolution / 64;
    const gpu::Buffer viewer_buffer = gpu::Buffer::from(viewers);
    const gpu::Buffer selected_buffer = gpu::Buffer::from(selected);
    const gpu::Buffer partial(viewers.size() * kGroups * sizeof(vec4));
    program_.use();
    program_.set("candidate_planes", 0);
    program_.set("resolution", kCoverageResolution);
    program_.set("selected_count", static_cast<int>(selected.size()));
    maps_->maps().planes().bind(0);
    centres_.bind_storage(0);
    viewer_buffer.bind_storage(1);
    selected_buffer.bind_storage(2);
    partial.bind_storage(3);
    glDispatchCompute(kGroups, static_cast<GLuint>(viewers.size()), 1);
    const std::vector<vec4> sums = partial.read<vec4>(viewers.size() * kGroups);

    std::vector<Coverage> result(viewers.size());
    for (std::size_t v = 0; v < viewers.size(); ++v) {
        double backs = 0;
        double hits = 0;
        double nearest = std::numeric_limits<double>::infinity();
        for (int g = 0; g < kGroups; ++g) {
            const vec4& s = sums[v * kGroups + static_cast<std::size_t>(g)];
            result[v].area += s.x;
            backs += s.y;
            hits += s.z;
            nearest = s.z > 0 ? std::min(nearest, static_cast<double>(s.w)) : nearest;
        }
        result[v].back_share = hits > 0 ? backs / hits : 0;
        result[v].seen_share = hits / (4.0 * kPi);
        result[v].min_distance = nearest;
    }
    return result;
}

bool in_the_open(const Coverage& coverage, float diagonal) {
    return coverage.seen_share > 0 && coverage.back_share < 0.05 && coverage.min_distance > 0.01 * diagonal;
}

}  // namespace lanthorn::gi
