// Where walls stand between points of a grid over the picture. A wall that is seen edge-on may be thinner
// than the points are apart, or than a pixel: both of its sides then look like one surface, and light must
// not be blurred across. The environment maps know: one that sees one of two points and not the other has the
// wall.
#pragma once

#include "gi_module/techniques/emc/gather/entry_list.h"
#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class GatherLinks {
  public:
    // Of the points (vec4: render space, octahedral normal) of another view, or on other surfaces. Walls
    // lower than 1.5 texels of a map are passed over. Cost: three looks at one map a point; short marches
    // where it does not see what it looks for.
    void find(const render::FrameInputs& inputs, const EnvironmentMaps& maps, const GiSettings& settings,
              const gpu::Buffer& points, ivec2 grid);

    // uint32 by cell, which a point is the lower left corner of: how far on a wall stands along its edges, in
    // 255ths of the way to the right or upwards, 8 bits each; 0: there is none. The lower edge, the upper,
    // the left, the right one.
    const gpu::Buffer& walls() const { return walls_; }
    // uint32 by point: a bit for each of the filter's links that a wall stands in; 8 for each of its levels
    // (gather_links.glsl).
    const gpu::Buffer& cuts() const { return cuts_[1]; }

  private:
    static constexpr int kLevels = 4;  // of the filter

    int count_ = 0;
    gpu::Program sharpest_map_, all_maps_, first_level_, next_level_;
    EntryList unseen_;       // pairs of neighbours that one map does not see both of
    gpu::Buffer crossings_;  // uint32 by point: of the lower and the left edge of its cell
    gpu::Buffer walls_;
    gpu::Buffer cuts_[2];
    gpu::BufferTexture points_view_, crossings_view_, cuts_view_;
};

}  // namespace lanthorn::gi
