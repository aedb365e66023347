#include "gi_module/shared/rays/embree_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gi_module/reference/tile_workers.h"
#include "gi_module/shared/rays/caustic_chains.h"
#include "gi_module/shared/rays/exact_rays.h"
#include "gi_module/shared/rays/followed_scene.h"
#include "gi_module/shared/rays/packed_normal.h"
#include "gi_module/shared/rays/specular_chain.h"
#include "gi_module/shared/rays/triangle_rays.h"

namespace lanthorn::gi {

namespace {

constexpr std::size_t kRun = 256;  // rays that a thread takes at once

class EmbreeRays final : public ExactRays {
  public:
    void follow(const FrameScene& scene, RayDetail detail) override { scene_.follow(scene, detail); }

    void trace(std::span<const ExactRay> rays, std::span<Arrival> arrivals, bool albedo) override {
        workers_.run((rays.size() + kRun - 1) / kRun, [&](std::size_t run) {
            const std::size_t first = run * kRun;
            const std::size_t end = std::min(first + kRun, rays.size());
            std::vector<RTCRayHit> queries;
            queries.reserve(kRun);
            for (std::size_t i = first; i < end; ++i) {
                queries.push_back(reference::TraceScene::query(rays[i].origin, rays[i].direction, 0,
                                                               std::numeric_limits<float>::infinity(),
                                                               reference::Blended::by_chance));
            }
            scene_.scene().intersect_all(queries);
            for (std::size_t i = first; i < end; ++i) {
                reference::SurfaceHit hit;
                if (!scene_.scene().found(queries[i - first], hit)) {
                    arrivals[i] = {};
                    continue;
                }
                arrivals[i] = {hit.t, pack_normal(hit.normal), albedo ? pack_albedo(hit) : 0};
            }
        });
    }

    std::vector<SpecularHit> trace(std::span<const SpecularRay> rays) override {
        return follow_chains(scene_, rays, workers_);
    }

    CausticArrivals trace_caustics(std::span<const CausticPhoton> photons, const CausticTargets& targets,
                                   int bounces, std::uint32_t seed) override {
        const CausticChains chains(scene_.scene(), scene_.materials(), targets, bounces, seed);
        std::vector<CausticArrivals> runs((photons.size() + kRun - 1) / kRun);
        workers_.run(runs.size(), [&](std::size_t run) {
            const std::size_t first = run * kRun;
            for (const CausticPhoton& p : photons.subspan(first, std::min(kRun, photons.size() - first))) {
                chains.follow(p, runs[run]);
            }
        });
        CausticArrivals all;
        all.straight.reserve(photons.size());
        for (const CausticArrivals& run : runs) {
            all.straight.insert(all.straight.end(), run.straight.begin(), run.straight.end());
            all.scattered.insert(all.scattered.end(), run.scattered.begin(), run.scattered.end());
        }
        return all;
    }

    std::vector<std::vector<SeenTriangle>> see(std::span<const CubeFace> faces,
                                               std::span<const std::uint8_t> stands) override {
        return see_triangles(scene_, faces, stands, workers_);
    }

    bool whole(std::uint32_t instance) const override { return scene_.scene().whole(instance); }

  private:
    std::uint32_t pack_albedo(const reference::SurfaceHit& hit) const {
        const vec3 albedo = scene_.materials().reflectance(scene_.scene().instances()[hit.instance],
                                                           hit.primitive, hit.barycentric);
        return glm::packUnorm4x8(vec4(albedo, 0));
    }

    FollowedScene scene_;
    reference::TileWorkers workers_{0};
};

}  // namespace

void add_embree_rays() {
    add_exact_rays([]() -> std::unique_ptr<ExactRays> { return std::make_unique<EmbreeRays>(); });
}

}  // namespace lanthorn::gi
