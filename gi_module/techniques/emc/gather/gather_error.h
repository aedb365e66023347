// What the error of a gathered picture is estimated from, found on the picture itself: noise by the two
// halves of the rays, and what filter and grid hide. error_model.h makes an error of it.
#pragma once

#include "lanthorn/gi/statistics.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

class GatherError {
  public:
    // By point of the grid; they must hold during the call alone.
    struct Picture {
        ivec2 grid{0};
        const gpu::Buffer& points;           // vec4: render space, octahedral normal
        const gpu::Buffer& irradiance;       // vec4: lux, before the filter; a: mean square luminance of rays
        const gpu::Buffer& filtered;         // vec4: lux; a < 0: nothing is known
        const gpu::Buffer& halves;           // RememberedHits::halves()
        const gpu::Buffer& filtered_halves;  // the same by the same filter
    };
    struct Parts {
        ErrorParts relrmse, local;
        bool known = false;  // there is light
    };
    // Waits for the GPU. Cost: some thirty fetches a point.
    Parts measure(const Picture& picture);

  private:
    static constexpr int kGroups = 64;  // kGroups of gather_error.comp

    void use(const gpu::Program& program, const Picture& picture);

    gpu::Program mean_program_, parts_program_;
    gpu::Buffer sums_;
    gpu::BufferTexture points_view_, irradiance_view_, filtered_view_, halves_view_, filtered_halves_view_;
};

}  // namespace lanthorn::gi
