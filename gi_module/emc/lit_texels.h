// Which texels of the environment maps are lit: of each surface those of the map that sees it sharpest.
#pragma once

#include "lanthorn/gi/emc/environment_maps.h"
#include "lanthorn/gi/emc/surface_points.h"

namespace lanthorn::gi {

class LitTexels {
  public:
    // Lists them anew, in an order that is none. Cost: a look at every map's centre a texel.
    void list(const EnvironmentMaps& maps, const GiSettings& settings, const FrameScene& scene);

    // lit_index and lit_points of lit_lookup.glsl on two texture units, and lit_resolution.
    void bind(const gpu::Program& program, gpu::BufferTexture& index, gpu::BufferTexture& points,
              GLuint unit) const;

    int resolution() const {
        return resolution_;
    }                                     // texels a cube-face edge: 64, or less if the maps have less
    int faces() const { return faces_; }  // of all maps
    const SurfacePoints& points() const { return points_; }
    const gpu::Buffer& index() const { return index_; }    // by place in the maps: number in the list + 1
    const gpu::Buffer& albedo() const { return albedo_; }  // vec4 by number: the mean over the texel

  private:
    int resolution_ = 0;
    int faces_ = 0;
    gpu::Program program_;
    SurfacePoints points_;
    gpu::Buffer index_;
    gpu::Buffer albedo_;
};

}  // namespace lanthorn::gi
