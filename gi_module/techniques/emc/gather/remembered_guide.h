// Guides the rays of the picture's points by where light came from at their tiles of 8 x 8 points: more rays
// go where the root mean square of what the remembered ones met is large, and count for less; none counts
// as more than four. The mean stays what it is. Where a tile has few rays, those around it count, too.
#pragma once

#include <functional>

#include "gi_module/techniques/emc/gather/entry_list.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

class RememberedGuide {
  public:
    // What is remembered (remembered_hits.h).
    struct Hits {
        ivec2 grid;
        const gpu::Buffer& cells;                      // by start: the point it serves
        const gpu::Buffer& counts;                     // by point
        const gpu::Buffer& irradiance;                 // by point, as it was shaded last
        std::function<void(const gpu::Program&)> use;  // makes it current, bound to what is remembered
        int slots;
    };
    void build_programs();
    // Room for guides of a grid, and for so many starts.
    void resize(ivec2 grid, std::size_t starts);
    // No tile knows anything.
    void forget() { frames_ = 0; }
    bool knows() const { return frames_ > 0; }
    // Looks at what the remembered rays have met: at all of them until each slot has been shot, then at those
    // of one slot, whose share of what is known from frames before goes. Cost: three fetches a ray, two
    // atomic sums, and 576 fetches a tile. 772 bytes a tile.
    void update(const Hits& hits, const gpu::Buffer& radiosity, int slot);
    // For the program that lists new rays, and the starts whose rays are to be guided.
    void bind(const gpu::Program& program, GLuint unit, GLuint starts_binding);
    // Guides the rays of the starts that were listed: flights and texels at storage bindings 5 and 4. Cost:
    // 64 fetches a start.
    void guide(const Hits& hits, std::uint32_t seed);

  private:
    int frames_ = 0;  // of update(), up to kFrames
    gpu::Program begin_, add_, level_, rays_;
    gpu::Buffer cells_;   // uvec2: 64 a tile
    gpu::Buffer means_;   // float by tile, lux
    gpu::Buffer levels_;  // float by cell, of its tile's mean
    EntryList starts_;
    gpu::BufferTexture cells_view_, means_view_, levels_view_, counts_view_, irradiance_view_,
        radiosity_view_;
};

}  // namespace lanthorn::gi
