// What rays from surface points have met in the last frames: not radiance but places, shaded anew whenever
// the light on them changes. Light may move or go out without a ray and without lag.
#pragma once

#include "lanthorn/gi/emc/environment_maps.h"
#include "lanthorn/gi/emc/lit_texels.h"
#include "lanthorn/gi/emc/map_rounds.h"
#include "lanthorn/gi/emc/surface_points.h"

namespace lanthorn::gi {

class RememberedHits {
  public:
    // Frames that are remembered; a power of two. The rays of frame f and of f + kFrames have the same
    // directions: nothing new is to be learnt from more frames of a still scene.
    static constexpr int kFrames = 16;

    void forget() { frames_ = 0; }
    int frames() const { return frames_; }
    bool complete() const { return frames_ == kFrames; }

    // One frame more of cosine-distributed rays from all points, those of the R2 sequence (Roberts 2018);
    // not when complete. What a ray meets is remembered as a number of `texels`, which must be the same ones
    // until forget(). Cost: one march a ray.
    void shoot(const SurfacePoints& points, const LitTexels& texels, const EnvironmentMaps& maps,
               const GiSettings& settings, const FrameScene& scene);
    // Irradiance in lux at all points, the mean radiosity (lux) of the texels that their rays have met, and
    // that of its luminance squared; -1 where none found what it met. Cost: a fetch a ray.
    const gpu::Buffer& shade(const SurfacePoints& points, const gpu::Buffer& radiosity);

  private:
    int frames_ = 0;
    int capacity_ = 0;  // points
    int rays_ = 0;
    gpu::Program one_map_;
    gpu::Program every_map_;
    gpu::Program shade_;
    Search search_ = Search::march;
    gpu::Buffer hits_;        // by frame, ray and point
    gpu::Buffer irradiance_;  // vec4 by point
    MapRounds rounds_;
    gpu::BufferTexture index_view_, points_view_, hits_view_, radiosity_view_;
};

}  // namespace lanthorn::gi
