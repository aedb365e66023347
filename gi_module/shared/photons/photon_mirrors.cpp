#include "gi_module/shared/photons/photon_mirrors.h"

namespace lanthorn::gi {

void PhotonMirrors::clear() {
    known_ = false;
    hits_.clear();
    surfaces_.clear();
    rays_ = 0;
}

void PhotonMirrors::shoot(const render::FrameInputs& inputs, const FollowedScene& scene, float roughness,
                          reference::TileWorkers& workers) {
    view_.shoot(inputs, roughness);
    const std::vector<SpecularRay> rays = view_.read_rays();
    hits_ = follow_chains(scene, rays, workers, &surfaces_);
    view_.set_hits(hits_);
    rays_ = rays.size();
    known_ = true;
}

const gpu::Texture& PhotonMirrors::shade(const render::FrameInputs& inputs, float roughness,
                                         std::span<const vec4> irradiances, bool lamps) {
    if (!bad_) {
        bad_ = gpu::Buffer(sizeof(std::uint32_t));
    }
    return view_.shade(inputs, roughness, bad_, [&](const gpu::Program& program) {
        program.set("lamps_are_known", lamps ? 1 : 0);
        irradiances_.hold(irradiances).bind_storage(MirrorView::kOwnBinding);
    });
}

std::uint64_t PhotonMirrors::bad() const {
    return bad_ ? bad_.read<std::uint32_t>(1).front() : 0;
}

}  // namespace lanthorn::gi
