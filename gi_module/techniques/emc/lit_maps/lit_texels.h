// Which texels of the environment maps are lit: of each surface those of the map that sees it sharpest. Known
// by their places in lists over all maps.
#pragma once

#include "gi_module/techniques/emc/gather/close_hits.h"
#include "gi_module/techniques/emc/gather/entry_list.h"
#include "gi_module/techniques/emc/gather/mover_programs.h"
#include "gi_module/techniques/emc/gather/surface_points.h"
#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "gi_module/techniques/emc/photons/sky_places.h"

namespace lanthorn::gi {

// Of 32 bits, that so many bits take.
inline std::size_t words_of_bits(int bits) {
    return (static_cast<std::size_t>(bits) + 31) / 32;
}

class LitTexels {
  public:
    static constexpr int kBlock = 4;  // texels a side that are looked at together

    // Room for `settings` and as many maps; whether that is another than before.
    bool resize(const EnvironmentMaps& maps, const GiSettings& settings);
    // Looks at the maps again: at all texels, or, if maps are those of before but for the one that has come
    // to slot exchanged.x, when that of exchanged.y left (-1: none), at those between which and any map's
    // centre things have moved and those that show what these two show. `radiosity`, `first`: vec4 by place;
    // a < 0 is written where no texel is lit, and `radiosity` 0 for those that were not before. Cost: a look
    // at every map's centre a texel; else a few a block, and the same for about a quarter of the texels.
    void look(const EnvironmentMaps& maps, const GiSettings& settings, const FrameScene& scene,
              const SweptBoxes& movers, bool all, const ivec2& exchanged, const gpu::Buffer& radiosity,
              const gpu::Buffer& first);

    // What the listed texels reflect, where colours alone have changed since they looked.
    void recolour(const EnvironmentMaps& maps, const GiSettings& settings, const FrameScene& scene,
                  const EntryList& lit);

    // lit_points.glsl: lit_points on a texture unit, and its other uniforms; sky_first.
    void bind(const gpu::Program& program, gpu::BufferTexture& points, GLuint unit) const;

    int resolution() const { return resolution_; }  // texels a cube-face edge: a multiple of 16
    int faces() const { return faces_; }            // of all maps
    int places() const { return faces_ * resolution_ * resolution_; }
    // With those of the sky, which follow them (sky_places.h).
    int all_places() const { return places() + kSkyPlaces; }
    // With those of close hits, which follow these.
    int shaded_places() const { return all_places() + CloseHits::kAllSlots; }
    int blocks() const { return places() / (kBlock * kBlock); }
    // By place; of points twice as many (lit_points.glsl).
    const gpu::Buffer& points() const { return points_; }
    const gpu::Buffer& albedo() const { return albedo_; }  // vec4: the mean over the texel
    // Blocks that the last look() looked at; dispatched with an invocation a texel.
    const EntryList& looked_at() const { return listed_; }
    // A bit each: the last look() found something else than the one before. From word changed_places() on
    // the same of blocks, unless all were looked at.
    const gpu::Buffer& changed() const { return changed_; }
    int changed_places() const { return shaded_places() / 32; }
    // The blocks of these bits, dispatched with an invocation each.
    const EntryList& changed_blocks() const { return changed_blocks_; }

  private:
    void list_changed_blocks();

    int resolution_ = 0;
    int faces_ = 0;
    gpu::Program program_, all_, recolour_, list_blocks_;
    MoverPrograms touched_{{"gi_module/techniques/emc/lit_maps/lit_touched.comp"}, {"ALL 0"}};
    gpu::Buffer points_;
    gpu::Buffer albedo_;
    gpu::Buffer changed_;
    gpu::Buffer sharper_;  // uvec2 by block: bits of the maps that its texels must ask
    EntryList listed_;     // blocks
    EntryList changed_blocks_;
    gpu::BufferTexture points_view_;
};

}  // namespace lanthorn::gi
