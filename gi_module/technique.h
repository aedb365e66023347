// The one door to indirect light: a technique takes a frame's scene and G-buffer and yields indirect
// irradiance.
#pragma once

#include <memory>

#include "lanthorn/deformation/detail.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/statistics.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class Technique {
  public:
    virtual ~Technique() = default;

    // Indirect light of this frame: irradiance in lux at the first visible surface (RGBA32F, full size; null:
    // none) and specular radiance where the technique has any. The textures belong to the technique and hold
    // until the next call. Call once a frame, in order: what changed is relative to the call before
    // (FrameScene::changes).
    virtual render::IndirectLight render(const render::FrameInputs& inputs, const GiSettings& settings) = 0;

    // Adds the centres of maps that the technique sees the scene from. `origin`: world position of the last
    // frame's render space.
    virtual void add_eyes(DetailHints&, const dvec3& /*origin*/) const {}

    // Of the last frame. `count_photons` reads photons back from the GPU: slow, for reports.
    virtual GiStatistics statistics(bool count_photons) = 0;
};

// Throws InputError for `path`: it renders no frames, reference::PathTracer is it.
std::unique_ptr<Technique> make_technique(TechniqueKind kind);

}  // namespace lanthorn::gi
