#include "gi_module/techniques/splat/picture_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lanthorn::gi {

namespace {

constexpr std::size_t kRun = 4096;  // pixels that a thread takes at once

// How far along its ray a pixel's surface may lie off what the rasteriser has drawn, shares of the distance:
// first by rounding, then by coarser triangles of far figures.
constexpr std::array<float, 2> kOff = {1e-4f, 2e-2f};

// A tile's place on a curve through the picture.
std::uint32_t curve(std::uint32_t tile, std::uint32_t width) {
    std::uint32_t result = 0;
    const std::uint32_t x = tile % width, y = tile / width;
    for (std::uint32_t bit = 0; bit < 15; ++bit) {
        result |= (x >> bit & 1u) << (2 * bit) | (y >> bit & 1u) << (2 * bit + 1);
    }
    return result;
}

}  // namespace

void PictureSurfaces::find(const render::FrameInputs& inputs, const PhotonScene& scene,
                           const SplatSurfaces& surfaces, reference::TileWorkers& workers) {
    grid_.find(inputs, 1);
    const GridPoints& points = grid_.points();
    std::vector<PixelSurface> pixels(points.lattice());
    const render::CameraUniforms& camera = inputs.camera;
    workers.run((pixels.size() + kRun - 1) / kRun, [&](std::size_t run) {
        for (std::size_t i = run * kRun; i < std::min((run + 1) * kRun, pixels.size()); ++i) {
            const SurfacePoint& point = points.points[i];
            pixels[i].position = point.position;
            if (!(point.distance > 0)) {
                continue;
            }
            const vec3 away =
                camera.orthographic ? camera.forward * point.distance : point.position - camera.position;
            const vec3 origin = camera.orthographic ? point.position - away : camera.position;
            reference::SurfaceHit hit;
            for (const float off : kOff) {
                if (scene.surfaces().intersect(origin, away, 1 - off, 1 + off, reference::Blended::solid, hit,
                                               reference::Sides::seen)) {
                    pixels[i].side = surfaces.side(hit.instance, hit.primitive, hit.front);
                    pixels[i].position = hit.position;  // where photons are
                    break;
                }
            }
        }
    });
    set(points.size, std::move(pixels));
}

void PictureSurfaces::set(ivec2 size, std::vector<PixelSurface> pixels, bool scattered) {
    size_ = size;
    scattered_ = scattered;
    pixels_ = std::move(pixels);
    make_patches();
}

void PictureSurfaces::make_patches() {
    patches_.clear();
    groups_.clear();
    const ivec2 grid = tiles();
    for (int ty = 0; ty < grid.y; ++ty) {
        for (int tx = 0; tx < grid.x; ++tx) {
            const std::size_t first = patches_.size();
            for (int y = ty * kTile; y < std::min((ty + 1) * kTile, size_.y); ++y) {
                for (int x = tx * kTile; x < std::min((tx + 1) * kTile, size_.x); ++x) {
                    const PixelSurface& pixel =
                        pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
                                static_cast<std::size_t>(x)];
                    if (pixel.side == kNoSide) {
                        continue;
                    }
                    auto patch =
                        std::find_if(patches_.begin() + static_cast<std::ptrdiff_t>(first), patches_.end(),
                                     [&](const SurfacePatch& p) { return p.side == pixel.side; });
                    if (patch == patches_.end()) {
                        patches_.push_back({{}, static_cast<std::uint32_t>(ty * grid.x + tx), pixel.side});
                        patch = patches_.end() - 1;
                    }
                    patch->bounds.add(pixel.position);
                }
            }
        }
    }
    const auto width = static_cast<std::uint32_t>(std::max(grid.x, 1));
    std::ranges::sort(patches_, [&](const SurfacePatch& a, const SurfacePatch& b) {
        return std::pair(a.side, curve(a.tile, width)) < std::pair(b.side, curve(b.tile, width));
    });
    for (std::uint32_t i = 0; i < patches_.size(); ++i) {
        const SurfacePatch& patch = patches_[i];
        if (groups_.empty() || groups_.back().side != patch.side ||
            groups_.back().count == PatchGroup::kMost) {
            groups_.push_back({{}, i, 0, patch.side});
        }
        groups_.back().bounds.add(patch.bounds);
        ++groups_.back().count;
    }
}

}  // namespace lanthorn::gi
