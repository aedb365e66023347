// Materials and meshes that scenes made in memory are put together from.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "lanthorn/scene/material.h"
#include "lanthorn/scene/mesh.h"

namespace lanthorn::support {

// Diffuse, no specular lobe.
inline Material lambertian(const vec3& albedo) {
    Material m;
    m.base_colour = vec4(albedo, 1);
    m.metallic = 0;
    m.specular = 0;
    return m;
}

// Reflects `colour` about the mirror's direction, of perceptual roughness 0..1: 0 is a mirror.
inline Material metal(const vec3& colour, float roughness) {
    Material m;
    m.base_colour = vec4(colour, 1);
    m.roughness = roughness;
    return m;
}

// Black, emitting `nits` from its front.
inline Material lamp(const vec3& nits) {
    Material m = lambertian(vec3(0));
    m.emissive = nits;
    return m;
}

// A parallelogram with corner `p` and edges `u`, `v`; its front is the side that u x v points to.
inline Mesh quad(const vec3& p, const vec3& u, const vec3& v, std::uint32_t material) {
    Mesh mesh;
    mesh.material = material;
    const vec3 n = glm::normalize(glm::cross(glm::normalize(u), glm::normalize(v)));
    for (const vec3& q : {p, p + u, p + u + v, p + v}) {
        Vertex vertex;
        vertex.position = q;
        vertex.normal = n;
        vertex.tangent = vec4(glm::normalize(u), 1);
        mesh.vertices.push_back(vertex);
        mesh.bounds.add(q);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

// A closed box; `inward`: its fronts face the inside.
inline Mesh box(const vec3& lower, const vec3& upper, bool inward, std::uint32_t material) {
    const vec3 s = upper - lower;
    const vec3 x(s.x, 0, 0);
    const vec3 y(0, s.y, 0);
    const vec3 z(0, 0, s.z);
    // Outward faces: corner and two edges whose product points out.
    const std::array<std::array<vec3, 3>, 6> faces{{{lower, z, y},
                                                    {lower + x, y, z},
                                                    {lower, x, z},
                                                    {lower + y, z, x},
                                                    {lower, y, x},
                                                    {lower + z, x, y}}};
    Mesh mesh;
    mesh.material = material;
    for (const auto& [p, u, v] : faces) {
        const Mesh face = inward ? quad(p, v, u, material) : quad(p, u, v, material);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), face.vertices.begin(), face.vertices.end());
        for (std::uint32_t i : face.indices) {
            mesh.indices.push_back(first + i);
        }
    }
    mesh.bounds = {lower, upper};
    return mesh;
}

// A subdivided icosahedron about `centre` with smooth normals, 20 * 4^levels triangles; `inward`: its fronts
// face the inside.
inline Mesh sphere(const vec3& centre, float radius, int levels, bool inward, std::uint32_t material) {
    const float g = 0.5f * (1.0f + std::sqrt(5.0f));
    std::vector<vec3> points{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                             {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (vec3& p : points) {
        p = glm::normalize(p);
    }
    std::vector<std::uint32_t> triangles{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                         4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                         6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [entry, fresh] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(points.size()));
            if (fresh) {
                points.push_back(glm::normalize(points[a] + points[b]));
            }
            return entry->second;
        };
        std::vector<std::uint32_t> finer;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const std::uint32_t a = triangles[i];
            const std::uint32_t b = triangles[i + 1];
            const std::uint32_t c = triangles[i + 2];
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
        }
        triangles = std::move(finer);
    }
    Mesh mesh;
    mesh.material = material;
    for (const vec3& p : points) {
        Vertex vertex;
        vertex.position = centre + radius * p;
        vertex.normal = inward ? -p : p;
        const vec3 aside = std::abs(p.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0);
        vertex.tangent = vec4(glm::normalize(glm::cross(p, aside)), 1);
        mesh.vertices.push_back(vertex);
        mesh.bounds.add(vertex.position);
    }
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const std::uint32_t a = triangles[i];
        const std::uint32_t b = triangles[i + 1];
        const std::uint32_t c = triangles[i + 2];
        mesh.indices.insert(mesh.indices.end(), {a, inward ? c : b, inward ? b : c});
    }
    return mesh;
}

}  // namespace lanthorn::support
