// Which surface each pixel shows (the item buffer of Lavignotte and Paulin 2003, sec. 3.3 and 5.2), and in
// what pieces the picture's tiles show them.
#pragma once

#include <span>
#include <vector>

#include "gi_module/reference/tile_workers.h"
#include "gi_module/shared/coarse_grid/coarse_grid.h"
#include "gi_module/shared/photons/photon_scene.h"
#include "gi_module/techniques/splat/splat_surfaces.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

inline constexpr SurfaceSide kNoSide = 0xffffffffu;

// splat.comp reads these.
struct PixelSurface {
    vec3 position{0};  // render space
    SurfaceSide side = kNoSide;
};
static_assert(sizeof(PixelSurface) == 16);

// What a tile shows of one surface.
struct SurfacePatch {
    Aabb bounds;
    std::uint32_t tile = 0;
    SurfaceSide side = 0;
};

// Patches near each other, all of one side.
struct PatchGroup {
    static constexpr std::uint32_t kMost = 16;

    Aabb bounds;
    std::uint32_t first = 0, count = 0;
    SurfaceSide side = 0;
};

class PictureSurfaces {
  public:
    static constexpr int kTile = 8;  // pixels

    // From the G-buffer: a ray asks each pixel's point for its triangle. Waits for the GPU.
    void find(const render::FrameInputs& inputs, const PhotonScene& scene, const SplatSurfaces& surfaces,
              reference::TileWorkers& workers);
    // The same from points; `size.x` times `size.y` of them, rows from the bottom. `scattered`: pixels side
    // by side may show places far from each other.
    void set(ivec2 size, std::vector<PixelSurface> pixels, bool scattered = false);

    ivec2 size() const { return size_; }
    ivec2 tiles() const { return (size_ + kTile - 1) / kTile; }
    bool scattered() const { return scattered_; }
    std::span<const PixelSurface> pixels() const { return pixels_; }
    std::span<const SurfacePatch> patches() const { return patches_; }  // by side, group and tile
    std::span<const PatchGroup> groups() const { return groups_; }      // by side

  private:
    void make_patches();

    CoarseGrid grid_;
    ivec2 size_{0};
    bool scattered_ = false;
    std::vector<PixelSurface> pixels_;
    std::vector<SurfacePatch> patches_;
    std::vector<PatchGroup> groups_;
};

}  // namespace lanthorn::gi
