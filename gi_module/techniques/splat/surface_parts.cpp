#include "gi_module/techniques/splat/surface_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "gi_module/shared/photons/copies.h"

namespace lanthorn::gi {

namespace {

constexpr double kLeastTurn = 0.81915;  // cosine of 35 degrees

struct Edge {
    std::uint32_t low, high;  // places of its ends
    std::uint32_t triangle;
    std::uint8_t side;  // of the triangle
    bool upward;        // the triangle goes from low to high
};

std::uint32_t root(std::vector<std::uint32_t>& parents, std::uint32_t i) {
    while (parents[i] != i) {
        i = parents[i] = parents[parents[i]];
    }
    return i;
}

}  // namespace

SurfaceParts surface_parts(std::span<const vec3> positions, std::span<const std::uint32_t> indices) {
    const auto count = static_cast<std::uint32_t>(indices.size() / 3);
    SurfaceParts parts;
    parts.neighbours.assign(count, {kNoTriangle, kNoTriangle, kNoTriangle});
    const std::vector<std::uint32_t> place = vertex_places(positions);
    parts.first_copy = first_of_copies(indices, place);
    std::vector<dvec3> normals(count);
    std::vector<Edge> edges;
    edges.reserve(3 * std::size_t{count});
    for (std::uint32_t t = 0; t < count; ++t) {
        const auto corners = indices.subspan(3 * std::size_t{t}, 3);
        const dvec3 p0(positions[corners[0]]);
        const dvec3 n = glm::cross(dvec3(positions[corners[1]]) - p0, dvec3(positions[corners[2]]) - p0);
        const double length = glm::length(n);
        normals[t] = length > 0 ? n / length : dvec3(0);
        for (std::uint8_t side = 0; side < 3; ++side) {
            const std::uint32_t a = place[corners[side]], b = place[corners[(side + 1u) % 3]];
            if (a != b && parts.first_copy[t] == t) {
                edges.push_back({std::min(a, b), std::max(a, b), t, side, a < b});
            }
        }
    }
    std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
        return std::tuple(a.low, a.high, a.triangle, a.side) < std::tuple(b.low, b.high, b.triangle, b.side);
    });
    std::vector<std::uint32_t> parents(count);
    std::iota(parents.begin(), parents.end(), 0u);
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t end = first + 1;
        while (end < edges.size() && edges[end].low == edges[first].low &&
               edges[end].high == edges[first].high) {
            ++end;
        }
        const Edge& a = edges[first];
        const Edge& b = edges[std::min(first + 1, edges.size() - 1)];
        // The other way round along the edge: both fronts on one side.
        if (end - first == 2 && a.upward != b.upward &&
            glm::dot(normals[a.triangle], normals[b.triangle]) > kLeastTurn) {
            parts.neighbours[a.triangle][a.side] = b.triangle;
            parts.neighbours[b.triangle][b.side] = a.triangle;
            const std::uint32_t ra = root(parents, a.triangle), rb = root(parents, b.triangle);
            parents[std::max(ra, rb)] = std::min(ra, rb);
        }
        first = end;
    }
    parts.of_triangle.resize(count);
    for (std::uint32_t t = 0; t < count; ++t) {  // a root stands before all of its part
        const std::uint32_t r = root(parents, parts.first_copy[t]);
        parts.of_triangle[t] = r == t ? parts.count++ : parts.of_triangle[r];
    }
    return parts;
}

}  // namespace lanthorn::gi
