// A frame's scene as photons meet it, kept from frame to frame: surfaces, materials and lights.
#pragma once

#include "gi_module/shared/photons/photon_tracer.h"
#include "gi_module/shared/rays/followed_scene.h"

namespace lanthorn::gi {

class PhotonScene {
  public:
    // Forgets everything: the next follow() builds it whole.
    void clear();
    // Becomes this frame's scene: refits what moved, builds anew if instances came or went. `scene` must stay
    // as it is until the last use of the frame. True if photons may go other ways than before: surfaces,
    // materials or lights differ. O(what changed + lights + emissive triangles + pixels of the sky).
    bool follow(const FrameScene& scene, PhotonScattering scattering);

    bool empty() const { return sources_.empty(); }
    const FollowedScene& followed() const { return scene_; }
    const reference::TraceScene& surfaces() const { return scene_.scene(); }
    const reference::MaterialTable& materials() const { return scene_.materials(); }
    const PhotonSources& sources() const { return sources_; }
    PhotonTracer tracer(const PhotonSettings& settings) const {
        return {surfaces(), materials(), sources_, settings};
    }
    std::uint64_t builds() const { return scene_.builds(); }  // of the whole structure so far

  private:
    FollowedScene scene_;
    PhotonSources sources_;
    PhotonScattering scattering_ = PhotonScattering::even;
    bool known_ = false;
};

}  // namespace lanthorn::gi
