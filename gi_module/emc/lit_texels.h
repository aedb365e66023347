// Which texels of the environment maps are lit: of each surface those of the map that sees it sharpest.
#pragma once

#include "lanthorn/gi/emc/environment_maps.h"
#include "lanthorn/gi/emc/surface_points.h"

namespace lanthorn::gi {

class LitTexels {
  public:
    // Lists them anew, in an order that is none. Cost: a look at every map's centre a texel.
    // `radiosity`: vec4 by place; a < 0 is written where no texel is lit, and 0 for those that were not
    // before.
    void list(const EnvironmentMaps& maps, const GiSettings& settings, const FrameScene& scene,
              const gpu::Buffer& radiosity);
    // Room for `settings` and as many maps; whether that is another than before.
    bool resize(const EnvironmentMaps& maps, const GiSettings& settings);

    // lit_index and lit_points of lit_lookup.glsl on two texture units, and lit_resolution.
    void bind(const gpu::Program& program, gpu::BufferTexture& index, gpu::BufferTexture& points,
              GLuint unit) const;

    int resolution() const { return resolution_; }  // texels a cube-face edge: a multiple of 16
    int faces() const { return faces_; }            // of all maps
    const SurfacePoints& points() const { return points_; }
    const gpu::Buffer& index() const { return index_; }  // by place in the maps: number in the list + 1
    // uint32 by place: not 0 where the last list() found something else than the one before.
    const gpu::Buffer& changed() const { return changed_; }
    const gpu::Buffer& albedo() const { return albedo_; }  // vec4 by number: the mean over the texel

  private:
    int resolution_ = 0;
    int faces_ = 0;
    gpu::Program program_;
    SurfacePoints points_;
    gpu::Buffer index_;
    gpu::Buffer albedo_;
    gpu::Buffer shown_;  // vec4 by place: the packed point that was shown
    gpu::Buffer changed_;
};

}  // namespace lanthorn::gi
