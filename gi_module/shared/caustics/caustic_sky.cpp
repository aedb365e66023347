#include "gi_module/shared/caustics/caustic_sky.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "lanthorn/core/colour.h"

namespace lanthorn::gi {

namespace {

using std::numbers::pi;

constexpr std::uint32_t kRows = 256;  // of pixels that are told apart: half the sun's width and more

// Of a pair of opposite faces one sees a direction.
dvec3 faces_of(const Aabb& box) {
    const dvec3 size = dvec3(box.upper) - dvec3(box.lower);
    return {size.y * size.z, size.z * size.x, size.x * size.y};
}

}  // namespace

CausticSky::CausticSky(const SkyInstance& sky)
    : image_(coarser(*sky.sky.lights_by(), kRows)),
      to_render_(glm::transpose(sky.to_sky)),
      scale_(sky.scale()) {
    // Faces are seen more squarely from some of a pixel than from its middle.
    const double width = 0.75 * pi / image_.height;
    dvec3 sum(0);
    for (std::vector<double>& c : cumulative_) {
        c.reserve(image_.radiance.size());
    }
    for (std::uint32_t y = 0; y < image_.height; ++y) {
        for (std::uint32_t x = 0; x < image_.width; ++x) {
            const vec2 middle((static_cast<float>(x) + 0.5f) / static_cast<float>(image_.width),
                              (static_cast<float>(y) + 0.5f) / static_cast<float>(image_.height));
            const dvec3 cosines = glm::abs(to_render_ * dvec3(sky_direction(middle))) + width;
            sum += cosines * (luminance(dvec3(image_.at(x, y)) * scale_) * image_.pixel_solid_angle(y));
            for (int axis = 0; axis < 3; ++axis) {
                cumulative_[static_cast<std::size_t>(axis)].push_back(sum[axis]);
            }
        }
    }
}

double CausticSky::flux_towards(const Aabb& box) const {
    if (box.empty() || image_.radiance.empty()) {
        return 0;
    }
    const dvec3 lux(cumulative_[0].back(), cumulative_[1].back(), cumulative_[2].back());
    const double flux = glm::dot(lux, faces_of(box));
    return std::isfinite(flux) ? flux : 0;
}

CausticSky::Entry CausticSky::enter(const Aabb& box, const glm::dvec2& u, const glm::dvec2& v) const {
    // A face by the light on it, then a pixel by its part of that; what is left of the number is the
    // longitude within the pixel.
    const dvec3 faces = faces_of(box);
    const double flux = flux_towards(box);
    double chosen = v.x * flux;
    int axis = 0;
    while (axis < 2) {
        const double here = cumulative_[static_cast<std::size_t>(axis)].back() * faces[axis];
        if (chosen < here) {
            break;
        }
        chosen -= here;
        ++axis;
    }
    while (axis > 0 && !(faces[axis] > 0 && cumulative_[static_cast<std::size_t>(axis)].back() > 0)) {
        --axis;  // rounding led to a face without light
    }
    const std::vector<double>& cumulative = cumulative_[static_cast<std::size_t>(axis)];
    const double lux = std::min(chosen / faces[axis], cumulative.back());
    const auto found = std::ranges::upper_bound(cumulative, lux);
    auto pixel = static_cast<std::size_t>(found - cumulative.begin());
    const auto before = [&](std::size_t i) { return i > 0 ? cumulative[i - 1] : 0.0; };
    while (pixel == cumulative.size() || !(cumulative[pixel] > before(pixel))) {
        --pixel;
    }
    const double part = cumulative[pixel] - before(pixel);

    const auto row = static_cast<std::uint32_t>(pixel / image_.width);
    const double column = static_cast<double>(pixel % image_.width);
    const double along = std::clamp((lux - before(pixel)) / part, 0.0, 1.0);
    const double upper = std::cos(pi * row / image_.height);
    const double lower = std::cos(pi * (row + 1) / image_.height);
    const double height = glm::mix(upper, lower, v.y);  // even by solid angle
    const double longitude = ((column + along) / image_.width - 0.5) * 2 * pi;
    const double flat = std::sqrt(std::max(1 - height * height, 0.0));
    Entry entry;
    entry.to_sky = to_render_ * dvec3(flat * std::cos(longitude), height, flat * std::sin(longitude));

    const double chance = part * faces[axis] / flux;
    entry.power = dvec3(image_.radiance[pixel]) * scale_ *
                  (image_.pixel_solid_angle(row) * std::abs(entry.to_sky[axis]) * faces[axis] / chance);
    const dvec3 size = dvec3(box.upper) - dvec3(box.lower);
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    entry.place = dvec3(box.lower);
    entry.place[axis] = entry.to_sky[axis] >= 0 ? box.upper[axis] : box.lower[axis];
    entry.place[second] += u.x * size[second];
    entry.place[third] += u.y * size[third];
    return entry;
}

}  // namespace lanthorn::gi
