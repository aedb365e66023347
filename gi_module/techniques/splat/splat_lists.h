// Which photons reach which tile of the picture: blocks of photons against what the tile shows of their
// surface. Pure functions, no GL.
#pragma once

#include <span>
#include <vector>

#include "gi_module/techniques/splat/photon_record.h"
#include "gi_module/techniques/splat/picture_surfaces.h"

namespace lanthorn::gi {

// splat.comp reads these.
struct SplatEntry {
    std::uint32_t first = 0;  // record of the run
    std::uint16_t count = 0;  // of records
    std::uint16_t group = 0;  // of lights
    SurfaceSide side = 0;
    float square = 0;  // h^2
    vec3 centre{0};    // of what the tile shows of that side
    float reach = 0;   // squared distance from there beyond which a photon lights none of it
};
static_assert(sizeof(SplatEntry) == 32 && PhotonBlock::kMost < 65536);

struct SplatLists {
    std::vector<SplatEntry> entries;    // by tile; in an order that depends on nothing else
    std::vector<std::uint32_t> firsts;  // by tile and one more
};

// How many of the blocks, from the first, make `most` entries at the very most, wherever they lie: at least
// one where there is any. A run is splatted so many at a time, so that neither wide kernels nor large
// pictures need more memory than that. O(blocks).
std::size_t blocks_at_once(std::span<const PhotonBlock> blocks, const PictureSurfaces& picture,
                           std::size_t most);

// `bandwidths`: by side, metres. `open`: by tile, whether it is to be splatted; empty: all are.
// O(blocks * groups of patches of their side / 8).
SplatLists splat_lists(std::span<const PhotonBlock> blocks, const PictureSurfaces& picture,
                       std::span<const float> bandwidths, std::span<const std::uint32_t> open,
                       reference::TileWorkers& workers);

}  // namespace lanthorn::gi
