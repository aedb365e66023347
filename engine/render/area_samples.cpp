#include "engine/render/area_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

namespace lanthorn::render {

namespace {

float luminance(const vec3& colour) {
    return glm::dot(colour, vec3(0.2126f, 0.7152f, 0.0722f));
}

struct Triangle {
    vec3 p[3];
    vec3 centre() const { return (p[0] + p[1] + p[2]) / 3.0f; }
    vec3 facing() const { return 0.5f * glm::cross(p[1] - p[0], p[2] - p[0]); }  // m^2 along the normal
    float area() const { return std::max(glm::length(facing()), 1e-30f); }
    // Its two parts, the first of them a share of it, by a cut from an edge to the corner that faces it.
    std::array<Triangle, 2> cut(float share, int edge) const {
        const vec3 a = p[edge], b = p[(edge + 1) % 3], apex = p[(edge + 2) % 3];
        const vec3 at = a + (b - a) * share;
        return {Triangle{{a, at, apex}}, Triangle{{at, b, apex}}};
    }
    int longest_edge() const {
        const auto length = [&](int i) { return glm::distance(p[i], p[(i + 1) % 3]); };
        return length(0) >= length(1) ? (length(0) >= length(2) ? 0 : 2) : length(1) >= length(2) ? 1 : 2;
    }
};

// A part of an emissive triangle: where it is, and where the mesh at rest has it. Parts are cut and grouped
// by the latter alone, so that rounding never groups a lamp that moves in another way.
struct Part {
    Triangle shown, rest;
};

// `count` parts of equal area, by halving the longest edge again and again.
void cut(const Part& t, int count, std::vector<Part>& parts) {
    if (count == 1) {
        parts.push_back(t);
        return;
    }
    const int edge = t.rest.longest_edge();
    const int first = count / 2;
    const float share = static_cast<float>(first) / static_cast<float>(count);
    const auto shown = t.shown.cut(share, edge), rest = t.rest.cut(share, edge);
    cut({shown[0], rest[0]}, first, parts);
    cut({shown[1], rest[1]}, count - first, parts);
}

struct Surface {
    std::span<const EmissiveTriangleData> shown;
    std::span<const EmissiveTriangles::Rest> rest;
};

// Of the surface: what is smaller may come and go with rounding, as the triangles at a sphere's poles do.
constexpr double kLeastShare = 1e-9;

// A surface in parts that are no larger than its share of a sample.
std::vector<Part> parts_of(const Surface& surface, int samples) {
    double whole = 0;
    std::vector<Part> triangles, parts;
    for (std::size_t i = 0; i < surface.shown.size(); ++i) {
        const EmissiveTriangleData& t = surface.shown[i];
        const EmissiveTriangles::Rest& rest = surface.rest[i];
        triangles.push_back({{{vec3(t.p0), vec3(t.p1), vec3(t.p2)}}, {{rest.p[0], rest.p[1], rest.p[2]}}});
        whole += static_cast<double>(triangles.back().rest.area());
    }
    for (const Part& triangle : triangles) {
        const double area = static_cast<double>(triangle.rest.area());
        if (std::max(area, static_cast<double>(triangle.shown.area())) < kLeastShare * whole) {
            continue;
        }
        const double shares = area / whole * samples;
        cut(triangle, std::max(1, static_cast<int>(std::ceil(shares - 1e-4))), parts);
    }
    return parts;
}

// Where a part lies and which way it faces: the same for a surface of any size, however it is turned.
struct Place {
    vec3 at{0}, normal{0};
};

float apart(const Place& a, const Place& b) {
    const vec3 d = a.at - b.at, n = a.normal - b.normal;
    return glm::dot(d, d) + glm::dot(n, n);
}

std::vector<Place> places_of(std::span<const Part> parts) {
    dvec3 centre(0);
    double area = 0, squares = 0;
    for (const Part& part : parts) {
        const double a = static_cast<double>(part.rest.area());
        centre += a * dvec3(part.rest.centre());
        area += a;
    }
    centre /= area;
    for (const Part& part : parts) {
        const dvec3 d = dvec3(part.rest.centre()) - centre;
        squares += static_cast<double>(part.rest.area()) * glm::dot(d, d);
    }
    const float size = static_cast<float>(std::sqrt(std::max(squares / area, 1e-20)));
    std::vector<Place> places;
    for (const Part& part : parts) {
        places.push_back({(part.rest.centre() - vec3(centre)) / size, part.rest.facing() / part.rest.area()});
    }
    return places;
}

// What groups begin with: parts that are spread in the order of the mesh, by the golden ratio. Steps of a
// ring's length would begin all of a bulb's in one line, from where rounding decides which way they go.
std::vector<Place> first_means(std::span<const Place> places, int count) {
    std::vector<bool> taken(places.size(), false);
    std::vector<Place> means;
    for (int g = 0; g < std::min(count, static_cast<int>(places.size())); ++g) {
        const double share = std::fmod(0.5 + 0.6180339887498949 * g, 1);
        auto i = static_cast<std::size_t>(share * static_cast<double>(places.size()));
        while (taken[i]) {
            i = (i + 1) % places.size();
        }
        taken[i] = true;
        means.push_back(places[i]);
    }
    return means;
}

std::size_t nearest_of(const Place& place, std::span<const Place> means) {
    std::size_t nearest = 0;
    for (std::size_t g = 1; g < means.size(); ++g) {
        // Of two as near the first, whatever rounding says.
        nearest = apart(place, means[g]) < 0.999f * apart(place, means[nearest]) ? g : nearest;
    }
    return nearest;
}

// Which of `count` groups each part belongs to: those of the nearest mean (Lloyd 1982). A closed surface has
// groups that face all ways.
std::vector<std::size_t> groups_of(std::span<const Part> parts, int count) {
    constexpr std::size_t kMostRounds = 16, kLeastRounds = 2;
    constexpr std::size_t kMostComparisons = 2'000'000;  // some 20 ms
    const std::vector<Place> places = places_of(parts);
    std::vector<Place> means = first_means(places, count);
    const std::size_t rounds =
        std::clamp(kMostComparisons / (parts.size() * means.size()), kLeastRounds, kMostRounds);
    std::vector<std::size_t> groups(parts.size(), means.size());
    bool changed = true;
    for (std::size_t round = 0; round < rounds && changed; ++round) {
        changed = false;
        std::vector<Place> sums(means.size());
        std::vector<float> areas(means.size(), 0);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::size_t nearest = nearest_of(places[i], means);
            changed = changed || nearest != groups[i];
            groups[i] = nearest;
            const float area = parts[i].rest.area();
            sums[nearest].at += area * places[i].at;
            sums[nearest].normal += area * places[i].normal;
            areas[nearest] += area;
        }
        for (std::size_t g = 0; g < means.size(); ++g) {
            if (areas[g] > 0) {
                means[g] = {sums[g].at / areas[g], sums[g].normal / areas[g]};
            }
        }
    }
    return groups;
}

// What stands for some parts: a point of them with nothing of them before it, and the way they face together.
struct Sample {
    vec3 point{0}, normal{0};
    float area = 0;  // m^2
};

Sample sample_of(std::span<const Part> parts) {
    Sample sample;
    vec3 faces(0), middle(0);
    const Part* largest = &parts.front();
    for (const Part& part : parts) {
        const float area = part.shown.area();
        sample.area += area;
        faces += part.shown.facing();
        middle += area * part.shown.centre();
        largest = area > largest->shown.area() ? &part : largest;
    }
    middle /= sample.area;
    // What faces all ways as a whole: one of its parts tells where to.
    constexpr float kLeastFacing = 0.1f;
    sample.normal =
        glm::normalize(glm::length(faces) > kLeastFacing * sample.area ? faces : largest->shown.facing());
    float foremost = -std::numeric_limits<float>::infinity();
    for (const Part& part : parts) {
        foremost = std::max(foremost, glm::dot(part.shown.centre() - middle, sample.normal));
    }
    const float slack = 1e-3f * std::sqrt(sample.area);
    float nearest = std::numeric_limits<float>::infinity();
    for (const Part& part : parts) {
        const vec3 off = part.shown.centre() - middle;
        if (glm::dot(off, sample.normal) >= foremost - slack && glm::dot(off, off) < 0.999f * nearest) {
            nearest = glm::dot(off, off);
            sample.point = part.shown.centre();
        }
    }
    return sample;
}

std::vector<Sample> samples_of(const Surface& surface, int count) {
    const std::vector<Part> parts = parts_of(surface, count);
    std::vector<std::vector<Part>> groups(static_cast<std::size_t>(count));
    const std::vector<std::size_t> group = groups_of(parts, count);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        groups[group[i]].push_back(parts[i]);
    }
    std::vector<Sample> samples;
    for (const std::vector<Part>& own : groups) {
        if (!own.empty()) {
            samples.push_back(sample_of(own));
        }
    }
    return samples;
}

LightData describe(const EmissiveTriangleData& t, const Sample& sample) {
    LightData light{};
    light.position = sample.point;
    light.range = 1e30f;
    light.direction = sample.normal;
    light.type = kLightAreaSample;
    light.intensity = vec3(t.radiance);
    light.area = sample.area;
    light.cos_outer = -1;
    light.layers = 6;
    light.extent = 1;
    light.two_sided = t.p1.w > 0 ? 1 : 0;
    return light;
}

}  // namespace

std::vector<LightData> make_area_samples(const EmissiveTriangles& emissive, const RenderSettings& settings) {
    std::vector<EmissiveTriangles::Surface> surfaces(emissive.surfaces().begin(), emissive.surfaces().end());
    std::ranges::stable_sort(surfaces, std::ranges::greater{},
                             [](const EmissiveTriangles::Surface& s) { return luminance(s.flux); });
    if (surfaces.size() > static_cast<std::size_t>(std::max(settings.area_lights_max, 0))) {
        surfaces.resize(static_cast<std::size_t>(std::max(settings.area_lights_max, 0)));
    }
    std::vector<LightData> samples;
    const int count = std::max(settings.area_lights_samples, 1);
    for (const EmissiveTriangles::Surface& surface : surfaces) {
        const Surface shape{emissive.triangles().subspan(surface.first, surface.count),
                            emissive.at_rest().subspan(surface.first, surface.count)};
        for (const Sample& sample : samples_of(shape, count)) {
            LightData light = describe(shape.shown.front(), sample);
            light.first_layer = static_cast<std::uint32_t>(samples.size()) * 6;
            light.texel = 2.0f / static_cast<float>(settings.area_lights_resolution);
            light.id = surface.instance_id;
            samples.push_back(light);
        }
    }
    return samples;
}

}  // namespace lanthorn::render
