#include "lanthorn/render/area_samples.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace lanthorn::render {

namespace {

using Surface = EmissiveTriangles::Surface;

float luminance(const vec3& colour) {
    return glm::dot(colour, vec3(0.2126f, 0.7152f, 0.0722f));
}

struct Triangle {
    vec3 p[3];
};

// Centroids of `count` parts of equal area, by halving the longest edge again and again.
void place(const Triangle& t, int count, std::vector<vec3>& points) {
    if (count == 1) {
        points.push_back((t.p[0] + t.p[1] + t.p[2]) / 3.0f);
        return;
    }
    int longest = 0;
    float length = -1;
    for (int i = 0; i < 3; ++i) {
        const float edge = glm::length(t.p[(i + 1) % 3] - t.p[i]);
        if (edge > length) {
            length = edge;
            longest = i;
        }
    }
    const vec3 a = t.p[longest];
    const vec3 b = t.p[(longest + 1) % 3];
    const vec3 apex = t.p[(longest + 2) % 3];
    const int first = count / 2;
    const vec3 cut = a + (b - a) * (static_cast<float>(first) / static_cast<float>(count));
    place({a, cut, apex}, first, points);
    place({cut, b, apex}, count - first, points);
}

// How many of `count` equal shares of the surface's flux fall to each triangle: those whose middle it holds.
std::vector<int> shares(std::span<const EmissiveTriangleData> triangles, double whole, int count) {
    std::vector<int> result;
    double sum = 0;
    int given = 0;
    for (const EmissiveTriangleData& t : triangles) {
        sum += static_cast<double>(t.p2.w);
        const int until = std::min(static_cast<int>(std::floor(sum / whole * count + 0.5)), count);
        result.push_back(std::max(until - given, 0));
        given = std::max(given, until);
    }
    result.back() += count - given;
    return result;
}

LightData describe(const EmissiveTriangleData& t, const vec3& position, double flux) {
    const bool two_sided = t.p1.w > 0;
    const double sides = two_sided ? 2 : 1;
    LightData light{};
    light.position = position;
    light.range = 1e30f;
    light.direction = glm::normalize(glm::cross(vec3(t.p1 - t.p0), vec3(t.p2 - t.p0)));
    light.type = kLightAreaSample;
    light.intensity = vec3(t.radiance);
    // The area that gives the sample its share of flux at this radiance.
    light.area = static_cast<float>(flux / (sides * kPi * static_cast<double>(luminance(vec3(t.radiance)))));
    light.cos_outer = -1;
    light.layers = 6;
    light.extent = 1;
    light.two_sided = two_sided ? 1 : 0;
    return light;
}

}  // namespace

std::vector<LightData> make_area_samples(const EmissiveTriangles& emissive, const RenderSettings& settings) {
    std::vector<Surface> surfaces(emissive.surfaces().begin(), emissive.surfaces().end());
    std::ranges::stable_sort(surfaces, std::ranges::greater{},
                             [](const Surface& s) { return luminance(s.flux); });
    if (surfaces.size() > static_cast<std::size_t>(std::max(settings.area_lights_max, 0))) {
        surfaces.resize(static_cast<std::size_t>(std::max(settings.area_lights_max, 0)));
    }
    std::vector<LightData> samples;
    const int count = std::max(settings.area_lights_samples, 1);
    for (const Surface& surface : surfaces) {
        const auto triangles = emissive.triangles().subspan(surface.first, surface.count);
        double whole = 0;
        for (const EmissiveTriangleData& t : triangles) {
            whole += static_cast<double>(t.p2.w);
        }
        const std::vector<int> counts = shares(triangles, whole, count);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            if (counts[i] == 0) {
                continue;
            }
            const EmissiveTriangleData& t = triangles[i];
            std::vector<vec3> points;
            place({{vec3(t.p0), vec3(t.p1), vec3(t.p2)}}, counts[i], points);
            for (const vec3& point : points) {
                LightData light = describe(t, point, whole / count);
                light.first_layer = static_cast<std::uint32_t>(samples.size()) * 6;
                light.texel = 2.0f / static_cast<float>(settings.area_lights_resolution);
                light.id = surface.instance_id;
                samples.push_back(light);
            }
        }
    }
    return samples;
}

}  // namespace lanthorn::render
