// The direct radiance maps of all lights, and the samples that stand for them (Frisvad et al. 2005, sec. 5,
// steps 1 and 2).
#pragma once

#include <vector>

#include "gi_module/shared/rays/exact_rays.h"
#include "gi_module/techniques/drm/drm_settings.h"
#include "gi_module/techniques/drm/light_pictures.h"
#include "gi_module/techniques/drm/picture_maps.h"
#include "gi_module/techniques/drm/radiance_sample.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class RadianceMap {
  public:
    // Makes the pictures that the light maps lack, and all samples. `exact`: follows light over mirrors and
    // through glass to where it arrives (null: that light is left out), where samples are means. Cost: the
    // pictures of emissive surfaces and, if settings ask for them, of samples (picture_maps.h), for which it
    // waits for the GPU; settings.texels^2 texels a light, and a ray of those that show a mirror, likewise.
    void make(const render::LightInputs& inputs, const DrmSettings& settings, ExactRays* exact,
              const gpu::Buffer& bad_values);

    const LightPictures& pictures() const { return pictures_; }
    int samples() const { return samples_; }
    int direct_samples() const { return direct_samples_; }    // of the lights' pictures: the first of them
    int sample_pictures() const { return sample_pictures_; }  // samples that have a picture
    int faces_drawn() const { return faces_drawn_; }          // by the last make()
    int mirrored() const { return mirrored_; }                // texels whose light was sent on, likewise
    std::vector<RadianceSample> read() const;                 // waits for the GPU

    // The samples, as drm_gather.glsl reads them, and its uniforms. `in_block`: the program has
    // SAMPLES_IN_BLOCK. At least one sample. Takes texture units 14 and 15.
    void bind(const gpu::Program& program, bool in_block) const;
    // Programs are to have SAMPLES_ARE_HIDDEN.
    bool hides() const { return hides_; }
    bool fits_block() const { return samples_ <= static_cast<int>(kMostBlockSamples); }

  private:
    // M, what a cell has, and which sample is written first.
    struct Grid {
        int side;
        int cell_texels;
        int pictures;
        int first;
    };
    void sample(const render::LightInputs& inputs, const PictureMaps& maps, const Grid& grid,
                const DrmSettings& settings, const gpu::Buffer& bad_values);
    void look_from_samples(const render::LightInputs& inputs, const DrmSettings& settings,
                           const gpu::Buffer& bad_values);
    void hide_all(const render::LightInputs& inputs, const DrmSettings& settings);
    void make_room(int samples);
    void follow_mirrored(const render::LightInputs& inputs, int width, ExactRays& exact);

    LightPictures pictures_;
    PictureMaps maps_, sample_maps_;            // of lights and of their samples,
    PictureMaps all_maps_;                      // and of those of both bounces
    const PictureMaps* hiding_maps_ = nullptr;  // of those that the samples name
    gpu::Program program_, mirrored_program_;
    gpu::Buffer list_;  // RadianceSample, room for a whole block
    int samples_ = 0;
    int direct_samples_ = 0;
    int sample_pictures_ = 0;
    bool hides_ = false;
    gpu::Buffer ray_count_, rays_;   // of light that is sent on: SpecularRay
    gpu::Buffer first_ends_, ends_;  // by texel, and SpecularHit
    int faces_drawn_ = 0;
    int mirrored_ = 0;
    int by_area_ = 1;           // as drm_gather.glsl says
    float least_distance_ = 0;  // squared
};

}  // namespace lanthorn::gi
