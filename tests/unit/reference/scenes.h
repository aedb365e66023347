// Scenes whose light is known on paper, traced.
#pragma once

#include <memory>
#include <utility>

#include "lanthorn/reference/path_tracer.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::reference::test {

using support::directional_light;
using support::lambertian;
using support::lamp;
using support::look_closely;
using support::point_light;
using support::quad;
using support::scene_of;
using support::sphere;
using support::spot_light;

// A sky of radiance `nits` where `lit` says so of a direction.
template <class Lit>
SkyInstance sky_of(float nits, const Lit& lit, std::uint32_t height = 64) {
    SkyImage image;
    image.height = height;
    image.width = 2 * height;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const vec3 d = sky_direction({(static_cast<float>(x) + 0.5f) / static_cast<float>(image.width),
                                          (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height)});
            image.radiance.push_back(lit(d) ? vec3(nits) : vec3(0));
        }
    }
    SkyInstance sky;
    sky.sky.image = std::make_shared<const SkyImage>(std::move(image));
    return sky;
}

// Mean over all pixels and channels of one AOV after settings.spp samples, in double precision.
double mean_of(const FrameScene& scene, const PathSettings& settings, PathAov aov, ivec2 size = ivec2(16));

}  // namespace lanthorn::reference::test
