#include "engine/render/emissive_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "lanthorn/core/colour.h"

namespace lanthorn::render {

namespace {

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

// A part of an emissive triangle: where it is, and where the mesh at rest has it.
struct Part {
    Triangle shown, rest;
    vec3 radiance{0};
    double bright = 1;      // how bright it is beside the brightest
    std::size_t piece = 0;  // label_pieces()

    double light() const { return bright * static_cast<double>(rest.area()); }
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
    cut({shown[0], rest[0], t.radiance, t.bright, t.piece}, first, parts);
    cut({shown[1], rest[1], t.radiance, t.bright, t.piece}, count - first, parts);
}

// Of the surface: what is smaller may come and go with rounding, as the triangles at a sphere's poles do.
constexpr double kLeastShare = 1e-9;

std::vector<Part> triangles_of(const EmissiveShape& shape) {
    std::vector<Part> triangles;
    double whole = 0;
    float brightest = 0;
    for (std::size_t i = 0; i < shape.shown.size(); ++i) {
        const EmissiveTriangleData& t = shape.shown[i];
        const EmissiveTriangles::Rest& rest = shape.rest[i];
        triangles.push_back(
            {{{vec3(t.p0), vec3(t.p1), vec3(t.p2)}}, {{rest.p[0], rest.p[1], rest.p[2]}}, vec3(t.radiance)});
        whole += static_cast<double>(triangles.back().rest.area());
        brightest = std::max(brightest, luminance(vec3(t.radiance)));
    }
    std::erase_if(triangles, [&](const Part& t) {
        return static_cast<double>(std::max(t.rest.area(), t.shown.area())) < kLeastShare * whole;
    });
    for (Part& t : triangles) {
        t.bright = static_cast<double>(luminance(t.radiance) / brightest);
    }
    return triangles;
}

struct CornerOrder {
    bool operator()(const vec3& a, const vec3& b) const {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    }
};

constexpr std::size_t kMostTold = 10'000;

// Writes Part::piece: triangles have the same if they share a corner, or one does with both. Returns how many
// pieces there are; of a surface of very many triangles (kMostTold) they are not told apart.
std::size_t label_pieces(std::vector<Part>& triangles) {
    if (triangles.size() > kMostTold) {
        return 1;
    }
    std::vector<std::size_t> parent(triangles.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
        while (parent[i] != i) {
            i = parent[i] = parent[parent[i]];
        }
        return i;
    };
    std::map<vec3, std::size_t, CornerOrder> corners;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (const vec3& p : triangles[i].rest.p) {
            parent[root(i)] = root(corners.try_emplace(p, i).first->second);
        }
    }
    std::map<std::size_t, std::size_t> labels;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        triangles[i].piece = labels.try_emplace(root(i), labels.size()).first->second;
    }
    return labels.size();
}

double light_of(std::span<const Part> parts) {
    return std::transform_reduce(parts.begin(), parts.end(), 0.0, std::plus{},
                                 [](const Part& part) { return part.light(); });
}

// Triangles in parts that have no more light than a sample's share.
std::vector<Part> parts_of(std::span<const Part> triangles, int samples) {
    const double whole = light_of(triangles);
    std::vector<Part> parts;
    for (const Part& triangle : triangles) {
        const double shares = triangle.light() / whole * samples;
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
        const double a = part.light();
        centre += a * dvec3(part.rest.centre());
        area += a;
    }
    centre /= area;
    for (const Part& part : parts) {
        const dvec3 d = dvec3(part.rest.centre()) - centre;
        squares += part.light() * glm::dot(d, d);
    }
    const float size = static_cast<float>(std::sqrt(std::max(squares / area, 1e-20)));
    std::vector<Place> places;
    for (const Part& part : parts) {
        places.push_back({(part.rest.centre() - vec3(centre)) / size, part.rest.facing() / part.rest.area()});
    }
    return places;
}

// The middle of each piece, if there are several and no more than `count`.
std::vector<Place> piece_means(std::span<const Part> parts, std::span<const Place> places, int count) {
    std::size_t pieces = 0;
    for (const Part& part : parts) {
        pieces = std::max(pieces, part.piece + 1);
    }
    if (pieces < 2 || pieces > static_cast<std::size_t>(count)) {
        return {};
    }
    std::vector<Place> means(pieces);
    std::vector<float> lights(pieces, 0);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto light = static_cast<float>(parts[i].light());
        means[parts[i].piece].at += light * places[i].at;
        means[parts[i].piece].normal += light * places[i].normal;
        lights[parts[i].piece] += light;
    }
    for (std::size_t k = 0; k < pieces; ++k) {
        means[k] = {means[k].at / lights[k], means[k].normal / lights[k]};
    }
    return means;
}

// What groups begin with: the pieces, and parts that are spread in the order of the mesh, by the golden
// ratio. Steps of a ring's length would begin all of a bulb's in one line, from where rounding decides which
// way they go.
std::vector<Place> first_means(std::span<const Part> parts, std::span<const Place> places, int count) {
    std::vector<bool> taken(places.size(), false);
    std::vector<Place> means = piece_means(parts, places, count);
    const int most = std::min(count, static_cast<int>(places.size()));
    for (int g = static_cast<int>(means.size()); g < most; ++g) {
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
std::vector<std::size_t> groups_of(std::span<const Part> parts, std::span<const Place> places, int count) {
    constexpr std::size_t kMostRounds = 16, kLeastRounds = 2;
    constexpr std::size_t kMostComparisons = 2'000'000;  // some 20 ms
    std::vector<Place> means = first_means(parts, places, count);
    const std::size_t rounds =
        std::clamp(kMostComparisons / (parts.size() * means.size()), kLeastRounds, kMostRounds);
    std::vector<std::size_t> groups(parts.size(), means.size());
    bool changed = true;
    for (std::size_t round = 0; round < rounds && changed; ++round) {
        changed = false;
        std::vector<Place> sums(means.size());
        std::vector<float> lights(means.size(), 0);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::size_t nearest = nearest_of(places[i], means);
            changed = changed || nearest != groups[i];
            groups[i] = nearest;
            const auto light = static_cast<float>(parts[i].light());
            sums[nearest].at += light * places[i].at;
            sums[nearest].normal += light * places[i].normal;
            lights[nearest] += light;
        }
        for (std::size_t g = 0; g < means.size(); ++g) {
            if (lights[g] > 0) {
                means[g] = {sums[g].at / lights[g], sums[g].normal / lights[g]};
            }
        }
    }
    return groups;
}

EmissiveSample sample_of(std::span<const Part> parts, std::span<const Place> places) {
    EmissiveSample sample;
    vec3 faces(0), middle(0), power(0);
    float light = 0;
    const Part* largest = &parts.front();
    for (const Part& part : parts) {
        const float area = part.shown.area();
        const auto bright = static_cast<float>(part.bright);
        sample.area += area;
        light += bright * area;
        power += area * part.radiance;
        faces += bright * part.shown.facing();
        middle += bright * area * part.shown.centre();
        largest =
            bright * area > static_cast<float>(largest->bright) * largest->shown.area() ? &part : largest;
    }
    middle /= light;
    sample.connected =
        std::ranges::all_of(parts, [&](const Part& p) { return p.piece == parts.front().piece; });
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const vec3* p = parts[i].shown.p;
        sample.faces.push_back({{p[0], p[1], p[2]}, parts[i].radiance, places[i].at, places[i].normal});
    }
    const bool even =
        std::ranges::all_of(parts, [&](const Part& p) { return p.radiance == parts.front().radiance; });
    sample.radiance = even ? parts.front().radiance : power / sample.area;
    // What faces all ways as a whole: one of its parts tells where to.
    constexpr float kLeastFacing = 0.1f;
    sample.normal =
        glm::normalize(glm::length(faces) > kLeastFacing * light ? faces : largest->shown.facing());
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

// Of the six axes of the mesh, how many of those that a surface faces most a twentieth of its light leaves
// along.
int ways_of(std::span<const Part> triangles) {
    constexpr double kLeast = 0.05;
    std::array<double, 6> light{};
    for (const Part& t : triangles) {
        const vec3 n = t.rest.facing(), a = glm::abs(n);
        const int axis = a.x >= a.y ? (a.x >= a.z ? 0 : 2) : a.y >= a.z ? 1 : 2;
        light[2 * static_cast<std::size_t>(axis) + (n[axis] < 0 ? 1 : 0)] += t.light();
    }
    const double whole = light_of(triangles);
    return static_cast<int>(std::ranges::count_if(light, [&](double l) { return l > kLeast * whole; }));
}

}  // namespace

int samples_wanted(const EmissiveShape& shape, int flat, int most) {
    std::vector<Part> triangles = triangles_of(shape);
    const int all_ways = std::max(flat, (flat * ways_of(triangles) + 1) / 2);
    const std::size_t apart =
        triangles.size() > kMostTold ? static_cast<std::size_t>(most) : label_pieces(triangles);
    const auto pieces = static_cast<int>(std::min(apart, static_cast<std::size_t>(most)));
    return std::min(std::max(all_ways, pieces), most);
}

std::vector<EmissiveSample> emissive_samples(const EmissiveShape& shape, int count) {
    std::vector<Part> triangles = triangles_of(shape);
    const bool told = triangles.size() <= kMostTold;
    label_pieces(triangles);
    const std::vector<Part> parts = parts_of(triangles, count);
    const std::vector<Place> places = places_of(parts);
    std::vector<std::vector<Part>> groups(static_cast<std::size_t>(count));
    std::vector<std::vector<Place>> places_in(groups.size());
    const std::vector<std::size_t> group = groups_of(parts, places, count);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        groups[group[i]].push_back(parts[i]);
        places_in[group[i]].push_back(places[i]);
    }
    std::vector<EmissiveSample> samples;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        if (!groups[g].empty()) {
            samples.push_back(sample_of(groups[g], places_in[g]));
            samples.back().connected = told && samples.back().connected;
        }
    }
    return samples;
}

}  // namespace lanthorn::render
