#include "gi_module/techniques/splat/kernel_areas.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::gi {

namespace {

constexpr int kStep = 4;        // pixels
constexpr float kEven = 0.02f;  // relative difference over a step that is interpolated over
constexpr double kPi2 = 3.14159265358979323846;

}  // namespace

float inverse_kernel_area(const PixelSurface& pixel, const SplatSurfaces& surfaces, float h,
                          PhotonKernel kernel, bool boundaries) {
    const double r = static_cast<double>(h);
    if (!(r > 0)) {
        return 0;
    }
    AreaMoment whole{kPi2 * r * r, 0.5 * kPi2 * r * r * r * r};
    if (boundaries) {
        whole = surfaces.tree(pixel.side).within(pixel.position, r);
    }
    const double integral =
        kernel == PhotonKernel::constant ? whole.area : whole.area - whole.moment / (r * r);
    // A point off its own surface by rounding may find none of it.
    return integral > 1e-9 * r * r ? static_cast<float>(1 / integral) : 0.0f;
}

std::vector<float> bandwidths(const SplatSurfaces& surfaces, std::span<const std::uint64_t> photons,
                              float c) {
    std::vector<float> result(photons.size(), 0);
    for (std::size_t side = 0; side < photons.size(); ++side) {
        if (photons[side] > 0) {
            const SurfaceTree& tree = surfaces.tree(static_cast<SurfaceSide>(side));
            const double h =
                static_cast<double>(c) * std::sqrt(tree.area() / static_cast<double>(photons[side]));
            result[side] = std::min(static_cast<float>(h), 1.001f * tree.bounds().diagonal());
        }
    }
    return result;
}

std::vector<float> inverse_kernel_areas(const PictureSurfaces& picture, const SplatSurfaces& surfaces,
                                        std::span<const float> bandwidths, PhotonKernel kernel,
                                        bool boundaries, std::span<const std::uint32_t> open,
                                        reference::TileWorkers& workers) {
    const ivec2 size = picture.size();
    const auto pixels = picture.pixels();
    std::vector<float> result(pixels.size(), 0);
    const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * size.x + x); };
    const auto compute = [&](int x, int y) {
        const std::size_t i = at(x, y);
        const auto tile = static_cast<std::size_t>(y / PictureSurfaces::kTile * picture.tiles().x +
                                                   x / PictureSurfaces::kTile);
        if (pixels[i].side != kNoSide && (open.empty() || open[tile] != 0)) {
            result[i] =
                inverse_kernel_area(pixels[i], surfaces, bandwidths[pixels[i].side], kernel, boundaries);
        }
    };
    const int step = boundaries && !picture.scattered() ? kStep : 1;
    const auto rows = static_cast<std::size_t>((size.y + step - 1) / step);
    workers.run(rows, [&](std::size_t row) {
        for (int x = 0; x < size.x; x += step) {
            compute(x, static_cast<int>(row) * step);
        }
    });
    if (step == 1) {
        return result;
    }
    // A square of the lattice at a time, without its upper and right sides.
    workers.run(rows, [&](std::size_t row) {
        const int y = static_cast<int>(row) * kStep;
        for (int x = 0; x < size.x; x += kStep) {
            const bool inside = x + kStep < size.x && y + kStep < size.y;
            bool even = inside;
            float least = 0, most = 0;
            if (inside) {
                const SurfaceSide side = pixels[at(x, y)].side;
                least = most = result[at(x, y)];
                for (int j = 0; j <= kStep; ++j) {
                    for (int i = 0; i <= kStep; ++i) {
                        even = even && pixels[at(x + i, y + j)].side == side;
                    }
                }
                for (const std::size_t k : {at(x + kStep, y), at(x, y + kStep), at(x + kStep, y + kStep)}) {
                    least = std::min(least, result[k]);
                    most = std::max(most, result[k]);
                }
                even = even && least > 0 && most - least <= kEven * most;  // 0: nobody has asked for it
            }
            for (int j = 0; j < kStep && y + j < size.y; ++j) {
                for (int i = 0; i < kStep && x + i < size.x; ++i) {
                    if (i == 0 && j == 0) {
                        continue;
                    }
                    if (!even) {
                        compute(x + i, y + j);
                        continue;
                    }
                    const float u = static_cast<float>(i) / kStep, v = static_cast<float>(j) / kStep;
                    result[at(x + i, y + j)] =
                        (result[at(x, y)] * (1 - u) + result[at(x + kStep, y)] * u) * (1 - v) +
                        (result[at(x, y + kStep)] * (1 - u) + result[at(x + kStep, y + kStep)] * u) * v;
                }
            }
        }
    });
    return result;
}

}  // namespace lanthorn::gi
