#include "gi_module/techniques/splat/point_splats.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <compare>
#include <unordered_map>
#include <utility>

#include "gi_module/techniques/splat/space_curve.h"

namespace lanthorn::gi {

namespace {

constexpr std::uint32_t kTile = PictureSurfaces::kTile;

// Where a point comes in a picture: by side, then along a curve through that side's points, so that those of
// far sides do not make its cells large; in one cell by position, since rays come in another order every
// time.
struct Place {
    SurfaceSide side = kNoSide;
    std::uint32_t cell = 0;
    std::array<std::uint32_t, 3> position{};  // its bits
    std::uint32_t point = 0;

    auto operator<=>(const Place&) const = default;
};

// The even bits of six.
std::uint32_t even_bits(std::uint32_t x) {
    return (x & 1u) | (x >> 1 & 2u) | (x >> 2 & 4u);
}

}  // namespace

PointPicture point_picture(std::span<const PixelSurface> points) {
    PointPicture result;
    result.pixels.assign(points.size(), kNoPixel);
    std::unordered_map<SurfaceSide, Aabb> boxes;
    std::vector<Place> order;
    for (const PixelSurface& point : points) {
        if (point.side != kNoSide) {
            boxes[point.side].add(point.position);
        }
    }
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const auto& [position, side] = points[i];
        if (side != kNoSide) {
            order.push_back({side, SpaceCurve(boxes.at(side), 10).place(position),
                             std::bit_cast<std::array<std::uint32_t, 3>>(position), i});
        }
    }
    if (order.empty()) {
        return result;
    }
    std::ranges::sort(order);
    const std::size_t tiles = (order.size() + kTile * kTile - 1) / (kTile * kTile);
    const auto across = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(tiles))));
    const auto rows = static_cast<std::uint32_t>((tiles + across - 1) / across);
    result.size = ivec2(kTile * across, kTile * rows);
    for (std::uint32_t k = 0; k < order.size(); ++k) {
        const std::uint32_t tile = k / (kTile * kTile), lane = k % (kTile * kTile);
        const std::uint32_t x = tile % across * kTile + even_bits(lane);
        const std::uint32_t y = tile / across * kTile + even_bits(lane >> 1);
        result.pixels[order[k].point] = y * kTile * across + x;
    }
    return result;
}

bool PointSplats::light(std::span<const PixelSurface> points, const SplatSurfaces& surfaces,
                        PhotonCollection& photons, std::span<const vec3> powers,
                        const SplatSettings& settings, reference::TileWorkers& workers,
                        std::vector<vec4>& irradiances) {
    irradiances.assign(points.size(), vec4(0));
    const PointPicture arranged = point_picture(points);
    if (arranged.size == ivec2(0)) {
        return true;
    }
    std::vector<PixelSurface> pixels(static_cast<std::size_t>(arranged.size.x * arranged.size.y));
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (arranged.pixels[i] != kNoPixel) {
            pixels[arranged.pixels[i]] = points[i];
        }
    }
    picture_.set(arranged.size, std::move(pixels), true);
    SplatSettings own = settings;
    own.adaptive = SplatAdaptive::none;
    const gpu::Texture* light = splats_.draw(picture_, surfaces, photons, powers, own, workers);
    bad_ += splats_.counts().bad;
    if (light == nullptr) {
        return false;
    }
    const std::vector<float> texels = light->read_floats(4);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (arranged.pixels[i] != kNoPixel) {
            const float* texel = texels.data() + 4 * std::size_t{arranged.pixels[i]};
            irradiances[i] = vec4(texel[0], texel[1], texel[2], 0);
        }
    }
    return true;
}

}  // namespace lanthorn::gi
