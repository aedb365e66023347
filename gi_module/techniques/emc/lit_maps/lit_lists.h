// Lists of the lit texels, and of the coarse points where their indirect irradiance is computed. What looks
// at the maps again and finds what was there stays where it is in them; so do all that did not look.
#pragma once

#include "gi_module/techniques/emc/gather/entry_list.h"
#include "gi_module/techniques/emc/gather/surface_points.h"
#include "gi_module/techniques/emc/lit_maps/lit_texels.h"

namespace lanthorn::gi {

class LitLists {
  public:
    // After each look of `texels`; `all`: from nothing, as it has to be when they all looked. `rays`: of a
    // coarse point and frame. Cost: a look at the blocks that show something else, and at 42 bits around
    // each; for `all`, and once in kWhole looks, at all texels.
    void follow(const LitTexels& texels, const EnvironmentMaps& maps, const GiSettings& settings,
                const FrameScene& scene, bool all, int rays);

    // Places of lit texels, and of some that are lit no more.
    const EntryList& lit() const { return lit_; }
    std::uint32_t lit_count() const;  // of those that are; waits for the GPU
    // Of each coarse texel with a lit one, the lit one nearest its middle; keys are their places, kNoPoint of
    // those that are no more.
    const SurfacePoints& coarse() const { return coarse_; }
    const gpu::Buffer& index() const { return index_; }  // of these, by place: number + 1
    int resolution() const { return resolution_; }       // of theirs, a side of a face

    // What the last follow() has found, unless it was for all: blocks with and beside texels that show
    // something else, dispatched with an invocation a texel; and coarse places up to four from such a
    // block's, along a row, a column or a diagonal.
    const EntryList& around() const { return around_; }
    const EntryList& reached() const { return reached_; }
    // By place of a lit texel, uint: which of the four coarse texels around it lie on its surface, a bit
    // each.
    const gpu::Buffer& fits() const { return fits_; }
    std::size_t bytes() const;

  private:
    // Looks until the lists are made as of nothing: of what is lit no more they hold a little at most.
    static constexpr int kWhole = 64;

    void resize(const LitTexels& texels, int rays);
    void list(const LitTexels& texels, bool whole);
    void find_around(const LitTexels& texels);
    void fit(const LitTexels& texels, const EnvironmentMaps& maps, const GiSettings& settings,
             const FrameScene& scene, bool all);

    EntryList lit_;
    SurfacePoints coarse_;
    gpu::Buffer index_;
    int resolution_ = 0;
    int texel_resolution_ = 0;
    int looks_ = 0;
    EntryList around_, reached_;
    gpu::Buffer held_;   // lit_lists.comp
    gpu::Buffer given_;  // the same
    gpu::Buffer marks_;  // lit_around.comp
    gpu::Buffer fits_;
    gpu::Program list_program_, around_program_, fits_program_;
    gpu::BufferTexture lit_points_view_, index_view_, points_view_;
};

}  // namespace lanthorn::gi
