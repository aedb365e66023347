// Path tracing from points of the picture, on the CPU (Kajiya 1986; the reference's own integrator), in a
// scene that is kept from frame to frame.
#pragma once

#include <optional>

#include "gi_module/reference/emitters.h"
#include "gi_module/reference/integrator.h"
#include "gi_module/reference/lights.h"
#include "gi_module/reference/tile_workers.h"
#include "gi_module/shared/rays/followed_scene.h"
#include "gi_module/techniques/coarse-path/point_history.h"

namespace lanthorn::gi {

class PointPaths {
  public:
    // Forgets the scene: the next follow() builds it whole.
    void clear();
    // The next samples are the first ones again.
    void begin_again() { samples_.clear(); }
    // Becomes this frame's scene: refits what moved, rebuilds if instances came or went. `scene` must stay as
    // it is until the last trace() of the frame. O(what changed); O(triangles log triangles) when built.
    void follow(const FrameScene& scene);
    // Adds counts[i] samples to estimates[i]: paths of 1 to `bounces` reflections. The samples of a pixel
    // follow each other from frame to frame, and are the same with any number of threads. Returns the rays it
    // took.
    std::uint64_t trace(const GridPoints& points, std::span<const int> counts, int bounces,
                        std::uint32_t seed, std::span<PointEstimate> estimates,
                        reference::TileWorkers& workers);

    std::uint64_t builds() const { return scene_.builds(); }  // of the whole scene so far
    std::uint64_t nan_count() const { return nan_count_; }    // samples left out so far

  private:
    FollowedScene scene_;
    std::optional<reference::Emitters> emitters_;
    std::optional<reference::PunctualLights> lights_;
    std::optional<SkyInstance> of_sky_;  // what sky_ was made of
    reference::SkyLight sky_;
    ivec2 size_{0};
    std::vector<std::uint32_t> samples_;  // taken so far, by pixel
    std::uint64_t nan_count_ = 0;
};

}  // namespace lanthorn::gi
