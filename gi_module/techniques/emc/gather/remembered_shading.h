// Shades points by what the remembered rays have met (remembered_hits.h): sorts the starts by the point that
// they serve, then takes the mean over each point's rays.
#pragma once

#include <functional>

#include "gi_module/techniques/emc/gather/prefix_sums.h"
#include "gi_module/techniques/emc/gather/surface_points.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

class RememberedShading {
  public:
    // What is remembered.
    struct Hits {
        const gpu::Buffer& cells;                      // of the picture: by start, the point it serves
        const gpu::Buffer& counts;                     // of the picture: by point, how many serve it
        std::function<void(const gpu::Program&)> use;  // makes it current, bound to what is remembered
    };

    // Room for so many points, each of whose `slots` have so many `rays`. `in_picture`: starts serve any
    // point; else those of a key its own. What was shaded before is gone.
    void resize(bool in_picture, int points, int slots, int rays);

    // Of the picture, before the first shade() after other rays or another view: makes the lists of the
    // starts that serve each point, in ascending order, of the first `slots`. Cost: a look at each start.
    void sort(const Hits& hits, int slots);
    // As RememberedHits has them. Cost: two fetches a ray.
    const gpu::Buffer& shade(const Hits& hits, const SurfacePoints& points, const gpu::Buffer& radiosity);
    const gpu::Buffer& halves(const Hits& hits, const SurfacePoints& points, const gpu::Buffer& radiosity);

    const gpu::Buffer& irradiance() const { return irradiance_; }  // of the last shade()
    const gpu::Buffer& known() const { return known_; }
    std::size_t bytes() const { return offsets_.bytes() + served_.bytes(); }  // of the lists

  private:
    void shade_by(const gpu::Program& program, const Hits& hits, const SurfacePoints& points,
                  const gpu::Buffer& radiosity);

    bool in_picture_ = false;
    int points_ = 0, slots_ = 0, rays_ = 0;
    gpu::Program empty_, sort_, order_, shade_, shade_halves_;
    // Of the picture, by point: where the list of the starts that serve it begins.
    PrefixSums offsets_;
    gpu::Buffer served_;      // uint32: starts, point by point
    gpu::Buffer irradiance_;  // vec4 by point
    gpu::Buffer known_;
    gpu::Buffer halves_;  // vec4 by point, of the last halves()
    gpu::BufferTexture cells_view_, counts_view_, offsets_view_, served_view_, radiosity_view_, keys_view_;
};

}  // namespace lanthorn::gi
