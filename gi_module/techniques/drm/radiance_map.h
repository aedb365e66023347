// The direct radiance maps of all lights, and the samples that stand for them (Frisvad et al. 2005, sec. 5,
// steps 1 and 2).
#pragma once

#include <vector>

#include "gi_module/shared/rays/exact_rays.h"
#include "gi_module/techniques/drm/drm_settings.h"
#include "gi_module/techniques/drm/light_pictures.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/render/light_map_array.h"
#include "lanthorn/render/scene_program.h"

namespace lanthorn::gi {

class RadianceMap {
  public:
    // Makes the pictures that the light maps lack, and all samples. `exact`: follows light over mirrors and
    // through glass to where it arrives (null: that light is left out), where samples are means. Cost: of an
    // emissive surface the triangles in its hemisphere, up to five times, and 12 bytes a texel;
    // settings.texels^2 texels a light, and a ray of those that show a mirror, for which it waits for the
    // GPU.
    void make(const render::LightInputs& inputs, const DrmSettings& settings, ExactRays* exact,
              const gpu::Buffer& bad_values);

    const LightPictures& pictures() const { return pictures_; }
    int samples() const { return samples_; }
    int faces_drawn() const { return faces_drawn_; }  // by the last make()
    int mirrored() const { return mirrored_; }        // texels whose light was sent on, likewise
    std::vector<RadianceSample> read() const;         // waits for the GPU

    // The samples, as drm_gather.glsl reads them, and its uniforms. `in_block`: the program has
    // SAMPLES_IN_BLOCK. At least one sample.
    void bind(const gpu::Program& program, bool in_block) const;
    bool fits_block() const { return samples_ <= static_cast<int>(kMostBlockSamples); }

  private:
    void draw(const render::LightInputs& inputs, int resolution);
    void draw_face(const render::LightInputs& inputs, const render::LightData& light, int face);
    void bind_pictures(const gpu::Program& program, const render::LightInputs& inputs) const;
    void follow_mirrored(const render::LightInputs& inputs, int width, ExactRays& exact);

    LightPictures pictures_;
    render::SceneProgram lamp_program_{"engine/render/light_map.vert",
                                       "gi_module/techniques/drm/lamp_picture.frag"};
    render::LightMapArray maps_{true};
    gpu::Program program_, mirrored_program_;
    gpu::Buffer lights_;
    gpu::Buffer shapes_;
    gpu::Buffer list_;  // RadianceSample, room for a whole block
    std::vector<render::DrawnInstance> visible_;
    int samples_ = 0;
    gpu::Buffer ray_count_, rays_;   // of light that is sent on: SpecularRay
    gpu::Buffer first_ends_, ends_;  // by texel, and SpecularHit
    int faces_drawn_ = 0;
    int mirrored_ = 0;
    bool by_area_ = true;
    float least_distance_ = 0;  // squared
};

}  // namespace lanthorn::gi
