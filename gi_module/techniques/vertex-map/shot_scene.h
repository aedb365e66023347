// The scene that photons are shot into, kept from frame to frame: as it is drawn, or with coarser shapes in
// it
// ("scene simplification", Jozwowski 2002, sec. 4.4.1, fig. 19).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "gi_module/shared/photons/photon_sources.h"
#include "gi_module/shared/photons/photon_tracer.h"
#include "gi_module/shared/rays/followed_scene.h"

namespace lanthorn::gi {

class ShotScene {
  public:
    // Forgets everything: the next follow() builds it whole.
    void clear();
    // Becomes this frame's scene: refits what moved, builds anew if instances came or went. `scene` must stay
    // as it is until the last use of the frame. `simplify`: how far a shape may lie off, a share of its own
    // box's diagonal; what emits stays as it is. True if photons may go other ways than before. O(what
    // changed
    // + lights + emissive triangles + pixels of the sky).
    bool follow(const FrameScene& scene, float simplify);

    const FollowedScene& followed() const { return scene_; }
    const reference::TraceScene& surfaces() const { return scene_.scene(); }
    const PhotonSources& sources() const { return sources_; }
    PhotonTracer tracer(const PhotonSettings& settings) const {
        return {surfaces(), scene_.materials(), sources_, settings};
    }
    std::uint64_t builds() const { return scene_.builds(); }  // of the whole structure so far
    std::uint64_t triangles() const;                          // that photons can meet

  private:
    reference::ReducedShapes reduced(const FrameScene& scene, float simplify);

    FollowedScene scene_;
    PhotonSources sources_;
    // By RefinedTopology::serial and a mesh's version.
    using Topology = std::pair<std::uint64_t, std::uint64_t>;
    struct Coarse {
        std::shared_ptr<const reference::ReducedShape> shape;  // null: none is within `simplify`
        bool used = false;
    };
    std::map<Topology, Coarse> shapes_;
    float simplify_ = 0;
};

}  // namespace lanthorn::gi
