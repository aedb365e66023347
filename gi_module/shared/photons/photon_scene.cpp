#include "gi_module/shared/photons/photon_scene.h"

namespace lanthorn::gi {

void PhotonScene::clear() {
    sources_ = {};
    scene_.clear();
    known_ = false;
}

bool PhotonScene::follow(const FrameScene& scene, PhotonScattering scattering) {
    const bool surfaces = scene_.follow(scene) || !known_ || !scene.changes.painted.empty();
    const bool changed = surfaces || scene.changes.lights || scattering != scattering_;
    scattering_ = scattering;
    known_ = true;
    if (changed) {
        sources_ = PhotonSources(scene_.scene(), scene_.materials(), &scene_.pieces());
    }
    return changed;
}

}  // namespace lanthorn::gi
