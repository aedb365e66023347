#include "lanthorn/coarse/embree_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lanthorn/coarse/followed_scene.h"
#include "lanthorn/coarse/specular_chain.h"
#include "lanthorn/gi/emc/exact_rays.h"
#include "lanthorn/reference/tile_workers.h"

namespace lanthorn::gi {

namespace {

constexpr std::size_t kRun = 256;  // rays that a thread takes at once

// As octahedral.glsl has it.
std::uint32_t pack_normal(const vec3& n) {
    const float l1 = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    vec2 p = l1 > 0 ? vec2(n.x, n.y) / l1 : vec2(0);
    if (n.z < 0) {
        const vec2 folded(1 - std::abs(p.y), 1 - std::abs(p.x));
        p = {p.x >= 0 ? folded.x : -folded.x, p.y >= 0 ? folded.y : -folded.y};
    }
    return glm::packSnorm2x16(p);
}

class EmbreeRays final : public ExactRays {
  public:
    void follow(const FrameScene& scene) override { scene_.follow(scene); }

    void trace(std::span<const ExactRay> rays, std::span<Arrival> arrivals) override {
        workers_.run((rays.size() + kRun - 1) / kRun, [&](std::size_t run) {
            const std::size_t first = run * kRun;
            const std::size_t end = std::min(first + kRun, rays.size());
            std::vector<RTCRayHit> queries;
            queries.reserve(kRun);
            for (std::size_t i = first; i < end; ++i) {
                queries.push_back(reference::TraceScene::query(rays[i].origin, rays[i].direction, 0,
                                                               std::numeric_limits<float>::infinity(),
                                                               reference::Blended::ignored));
            }
            scene_.scene().intersect_all(queries);
            for (std::size_t i = first; i < end; ++i) {
                reference::SurfaceHit hit;
                if (!scene_.scene().found(queries[i - first], hit)) {
                    arrivals[i] = {};
                    continue;
                }
                arrivals[i] = {hit.t, pack_normal(hit.normal)};
            }
        });
    }

    void trace(std::span<const SpecularRay> rays, std::span<SpecularHit> hits) override {
        workers_.run((rays.size() + kRun - 1) / kRun, [&](std::size_t run) {
            const std::size_t end = std::min((run + 1) * kRun, rays.size());
            for (std::size_t i = run * kRun; i < end; ++i) {
                hits[i] = follow_chain(scene_, rays[i]);
            }
        });
    }

  private:
    FollowedScene scene_;
    reference::TileWorkers workers_{0};
};

}  // namespace

void add_embree_rays() {
    add_exact_rays([]() -> std::unique_ptr<ExactRays> { return std::make_unique<EmbreeRays>(); });
}

}  // namespace lanthorn::gi
