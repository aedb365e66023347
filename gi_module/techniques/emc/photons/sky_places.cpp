#include "gi_module/techniques/emc/photons/sky_places.h"

#include <cmath>

namespace lanthorn::gi {

namespace {

constexpr std::uint32_t kImageRows = 64;  // of the image that is looked at: several pixels a cell
constexpr int kLooks = 4;                 // a cell and axis

// octahedral.glsl's octahedral_vector(): |x| + |y| + |z| = 1.
vec3 octahedral_vector(const vec2& e) {
    vec3 n(e, 1 - std::abs(e.x) - std::abs(e.y));
    const float fold = std::max(-n.z, 0.0f);
    n.x += n.x >= 0 ? -fold : fold;
    n.y += n.y >= 0 ? -fold : fold;
    return n;
}

}  // namespace

std::vector<vec4> sky_radiosity(const std::optional<SkyInstance>& sky) {
    std::vector<vec4> cells(kSkyPlaces, vec4(0));
    if (!sky) {
        return cells;
    }
    const SkyImage image = coarser(*sky->sky.lights_by(), kImageRows);
    dvec3 wanted(0), found(0);
    double sphere = 0;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            wanted += dvec3(image.at(x, y)) * image.pixel_solid_angle(y);
        }
    }
    for (int i = 0; i < kSkyPlaces; ++i) {
        dvec3 sum(0);
        double weight = 0;
        for (int k = 0; k < kLooks * kLooks; ++k) {
            const vec2 at = vec2(i % kSkySide, i / kSkySide) +
                            (vec2(k % kLooks, k / kLooks) + 0.5f) / static_cast<float>(kLooks);
            const vec3 v = octahedral_vector(2.0f * at / static_cast<float>(kSkySide) - 1.0f);
            const float length = glm::length(v);
            // Solid angle of a part of the octahedron's faces: area times cosine over the distance squared.
            const double w =
                1 / (static_cast<double>(length) * static_cast<double>(length) * static_cast<double>(length));
            sum += w * dvec3(sky_radiance(image, sky->to_sky * (v / length)));
            weight += w;
        }
        cells[static_cast<std::size_t>(i)] = vec4(vec3(sum / weight), 0);
        found += sum;
        sphere += weight;
    }
    const double pi = static_cast<double>(kPi);
    for (int c = 0; c < 3; ++c) {
        const double mean = found[c] / sphere, expected = wanted[c] / (4 * pi);
        const double scale = mean > 0 ? expected / mean : 1;
        for (vec4& cell : cells) {
            cell[c] *= static_cast<float>(scale * pi) * sky->scale()[c];
        }
    }
    return cells;
}

}  // namespace lanthorn::gi
