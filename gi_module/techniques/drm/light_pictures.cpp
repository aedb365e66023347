#include "gi_module/techniques/drm/light_pictures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lanthorn/core/colour.h"

namespace lanthorn::gi {

namespace {

using render::LightData;

constexpr float kSameWay = 0.8f;  // cosine between samples of a surface that are one light
constexpr float kAsNear = 0.05f;  // of its side: less than between samples

struct Candidate {
    LightData light;
    LightPicture shape;
    float flux = 0;  // lumen
};

// What of a parallel light's map the scene's box covers.
vec4 window_of(const LightData& light, const Aabb& bounds) {
    vec2 least(std::numeric_limits<float>::infinity()), most(-least);
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 p((corner & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                     (corner & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                     (corner & 4) != 0 ? bounds.upper.z : bounds.lower.z);
        const vec2 at(glm::dot(p - light.position, light.right), glm::dot(p - light.position, light.up));
        least = glm::min(least, at);
        most = glm::max(most, at);
    }
    return vec4(least, most);
}

Candidate of_punctual(const LightData& light, const Aabb& bounds) {
    Candidate c{light, {}, 0};
    const float brightness = luminance(light.intensity);
    if (light.type == render::kLightDirectional) {
        c.shape.shape = kPictureParallel;
        c.shape.window = window_of(light, bounds);
        c.flux = brightness * (c.shape.window.z - c.shape.window.x) * (c.shape.window.w - c.shape.window.y);
    } else if (light.type == render::kLightSpot) {
        c.shape.shape = kPictureCone;
        c.flux = brightness * 2 * kPi * (1 - light.cos_outer);
    } else {
        c.shape.shape = kPictureSphere;
        c.flux = brightness * 4 * kPi;
    }
    return c;
}

// One light for samples of a surface that face about the same way. Sums of what is near the largest float
// hold in doubles.
LightData merged(const std::vector<const LightData*>& samples) {
    dvec3 middle(0), facing(0), intensity(0);
    double area = 0;
    for (const LightData* sample : samples) {
        const auto share = static_cast<double>(sample->area);
        middle += share * dvec3(sample->position);
        facing += share * dvec3(sample->direction);
        intensity += share * dvec3(sample->intensity);
        area += share;
    }
    middle /= area;
    // Of those that lie about as near as the nearest, always the same: which of four about a panel's middle
    // is nearest is a matter of rounding, and the picture would jump among them while the panel moves.
    const auto off = [&](const LightData* sample) { return glm::distance(dvec3(sample->position), middle); };
    const auto nearest = std::ranges::min_element(samples, {}, off);
    const double near = off(*nearest) + static_cast<double>(kAsNear) * std::sqrt(area);
    const auto first = std::ranges::find_if(samples, [&](const LightData* s) { return off(s) <= near; });
    LightData light = **(first != samples.end() ? first : nearest);
    light.direction = vec3(glm::normalize(facing));
    light.intensity = vec3(intensity / area);
    light.area = static_cast<float>(area);
    return light;
}

void add_surface(const LightData& light, std::vector<Candidate>& all) {
    for (const float side : {1.0f, -1.0f}) {
        if (side < 0 && light.two_sided == 0) {
            return;
        }
        Candidate c{light, {}, luminance(light.intensity) * kPi * light.area};
        c.light.direction = side * light.direction;
        const vec3 helper = std::abs(c.light.direction.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0);
        c.light.right = glm::normalize(glm::cross(c.light.direction, helper));
        c.light.up = glm::cross(c.light.right, c.light.direction);
        c.light.two_sided = 0;
        c.light.layers = 6;
        c.shape.shape = kPictureHemisphere;
        c.shape.drawn_here = 1;
        all.push_back(c);
    }
}

// Of one surface; they follow each other.
void add_surfaces(std::span<const LightData> samples, std::vector<Candidate>& all) {
    std::vector<std::vector<const LightData*>> groups;
    for (const LightData& sample : samples) {
        if (!(sample.area > 0)) {
            continue;
        }
        const auto group = std::ranges::find_if(groups, [&](const auto& g) {
            return glm::dot(g.front()->direction, sample.direction) > kSameWay;
        });
        if (group != groups.end()) {
            group->push_back(&sample);
        } else {
            groups.push_back({&sample});
        }
    }
    for (const auto& group : groups) {
        add_surface(merged(group), all);
    }
}

}  // namespace

LightPictures choose_pictures(std::span<const LightData> lights, int punctual, const Aabb& bounds, int most) {
    std::vector<Candidate> all;
    for (const LightData& light : lights.first(static_cast<std::size_t>(punctual))) {
        if (light.layers > 0 && light.shares_map == 0) {
            all.push_back(of_punctual(light, bounds));
        }
    }
    for (std::size_t i = static_cast<std::size_t>(punctual); i < lights.size();) {
        std::size_t end = i + 1;
        while (end < lights.size() && lights[end].id == lights[i].id) {
            ++end;
        }
        add_surfaces(lights.subspan(i, end - i), all);
        i = end;
    }
    LightPictures result;
    const auto sends = [](const Candidate& c) { return c.flux > 0 && std::isfinite(c.flux); };
    result.dark = static_cast<int>(all.size() - static_cast<std::size_t>(std::ranges::count_if(all, sends)));
    std::erase_if(all, [&](const Candidate& c) { return !sends(c); });
    if (all.size() > static_cast<std::size_t>(most)) {
        result.left_out = static_cast<int>(all.size()) - most;
        // In their own order, so that a sum over them does not change with their brightness.
        std::vector<std::size_t> order(all.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return all[i].flux; });
        order.resize(static_cast<std::size_t>(most));
        std::ranges::sort(order);
        std::vector<Candidate> kept;
        kept.reserve(order.size());
        for (const std::size_t i : order) {
            kept.push_back(all[i]);
        }
        all = std::move(kept);
    }
    std::uint32_t layers = 0;
    for (Candidate& c : all) {
        if (c.shape.drawn_here != 0) {
            c.light.first_layer = layers;
            layers += c.light.layers;
        }
        result.lights.push_back(c.light);
        result.shapes.push_back(c.shape);
    }
    return result;
}

}  // namespace lanthorn::gi
