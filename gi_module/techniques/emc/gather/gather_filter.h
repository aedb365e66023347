// The filter of what rays bring to a grid of surface points: variance-guided a-trous (Schied et al. 2017).
#pragma once

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

class GatherFilter {
  public:
    // What is filtered, by point of the grid. It must hold during the call alone.
    struct Points {
        ivec2 grid{0};
        const gpu::Buffer& points;  // vec4: render space, octahedral normal
        const gpu::Buffer&
            irradiance;            // vec4: lux; a: mean square luminance of the rays, < 0: nothing is known
        const gpu::Buffer& known;  // float: rays behind it
        const gpu::Buffer& cuts;   // uint32: links that a wall stands in (gather_links.h)
    };
    struct Width {
        // 0 takes away the noise of few rays and blurs, 1 is enough for a settled picture; between them the
        // picture sharpens without a step.
        float narrow = 0;
        bool by_rays = false;  // narrower at points that have many
    };
    // vec4 by point, lux; a < 0: nothing is known. Cost: 9 points a point and level, 2 levels where all are
    // narrow, else 4.
    const gpu::Buffer& run(const Points& points, Width width);
    // Other values of the same points, with the weights and the width of the last run(): vec4 by point, a
    // < 0: nothing is known. What noise becomes.
    const gpu::Buffer& again(const Points& points, const gpu::Buffer& values);

  private:
    void allocate(int count);
    const gpu::Buffer& levels(const Points& points, const gpu::Buffer& values, gpu::Buffer (&filtered)[2]);
    void use(const gpu::Program& program, const Points& points, const gpu::Buffer& irradiance);

    int count_ = 0;
    gpu::Program prefilter_programs_[2], filter_program_;
    gpu::Buffer guides_[2];
    gpu::Buffer filtered_[2], again_[2];
    int pooled_ = 1;  // levels of the guide, of the last run()
    Width width_;
    gpu::BufferTexture points_view_, irradiance_view_, guide_view_, known_view_, cuts_view_;
};

}  // namespace lanthorn::gi
