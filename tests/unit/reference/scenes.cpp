#include "tests/unit/reference/scenes.h"

#include <numeric>

namespace lanthorn::reference::test {

double mean_of(const FrameScene& scene, const PathSettings& settings, PathAov aov, ivec2 size) {
    PathTracer tracer(scene, size, settings,
                      {aov == PathAov::indirect, aov == PathAov::direct, aov == PathAov::radiance});
    tracer.render({});
    const std::vector<float> pixels = tracer.image(aov);
    return std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
}

}  // namespace lanthorn::reference::test
