#include "engine/assets/vertex_frames.h"
#include "engine/core/finite.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace lanthorn {

namespace {

using Corners = std::array<std::uint32_t, 3>;

Corners corners(const Mesh& mesh, std::size_t triangle) {
    return {mesh.indices[triangle * 3], mesh.indices[triangle * 3 + 1], mesh.indices[triangle * 3 + 2]};
}

dvec3 position(const Mesh& mesh, std::uint32_t vertex) {
    return mesh.vertices[vertex].position;
}

// Twice the triangle's area along its normal. Double precision: squares of any finite float fit.
dvec3 area_vector(const Mesh& mesh, const Corners& c) {
    const dvec3 origin = position(mesh, c[0]);
    return glm::cross(position(mesh, c[1]) - origin, position(mesh, c[2]) - origin);
}

// `v` at unit length, or zero if it has no direction.
vec3 direction(const dvec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0) || !std::isfinite(largest)) {
        return vec3(0);
    }
    return vec3(glm::normalize(v / largest));
}

vec3 perpendicular(const vec3& normal) {
    const vec3 axis = std::abs(normal.x) < 0.6f ? vec3(1, 0, 0) : vec3(0, 1, 0);
    return glm::normalize(axis - normal * glm::dot(normal, axis));
}

vec2 uv_of(const Vertex& vertex, std::uint32_t uv_set) {
    return uv_set == 0 ? vertex.uv0 : vertex.uv1;
}

// Which way round a triangle's texture lies: +1 as glTF's own (V down), -1 mirrored, 0 without area.
int texture_side(double uv_area) {
    return uv_area < 0 ? 1 : uv_area > 0 ? -1 : 0;
}

double uv_area(const Mesh& mesh, const Corners& c, std::uint32_t uv_set) {
    const glm::dvec2 a = uv_of(mesh.vertices[c[0]], uv_set);
    const glm::dvec2 b = glm::dvec2(uv_of(mesh.vertices[c[1]], uv_set)) - a;
    const glm::dvec2 d = glm::dvec2(uv_of(mesh.vertices[c[2]], uv_set)) - a;
    return b.x * d.y - d.x * b.y;
}

VertexSources every_vertex(const Mesh& mesh) {
    VertexSources sources(mesh.vertices.size());
    std::iota(sources.begin(), sources.end(), 0u);
    return sources;
}

// Splits vertices between triangles of different sides and returns the side of every vertex, 0 where all are
// 0. Without `sources`, nothing is split and the first triangle with a side decides.
std::vector<std::int8_t> split_mirrored(Mesh& mesh, std::uint32_t uv_set, VertexSources* sources) {
    std::vector<std::int8_t> side(mesh.vertices.size(), 0);
    std::vector<std::uint32_t> twin(mesh.vertices.size(), 0);  // 0: none yet (a twin is never vertex 0)
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        const auto wanted = static_cast<std::int8_t>(texture_side(uv_area(mesh, corners(mesh, t), uv_set)));
        for (std::size_t k = 0; k < 3 && wanted != 0; ++k) {
            const std::uint32_t vertex = mesh.indices[t * 3 + k];
            if (side[vertex] == 0) {
                side[vertex] = wanted;
            } else if (side[vertex] != wanted && sources) {
                if (twin[vertex] == 0) {
                    twin[vertex] = static_cast<std::uint32_t>(mesh.vertices.size());
                    mesh.vertices.push_back(Vertex(mesh.vertices[vertex]));
                    sources->push_back(vertex);
                    side.push_back(wanted);
                    twin.push_back(0);
                }
                mesh.indices[t * 3 + k] = twin[vertex];
            }
        }
    }
    return side;
}

}  // namespace

std::size_t remove_flat_triangles(Mesh& mesh, const std::function<bool(const Corners&)>& may_open) {
    constexpr double kFlat = 1e-12;
    std::size_t kept = 0;
    const std::size_t count = mesh.indices.size() / 3;
    for (std::size_t t = 0; t < count; ++t) {
        const Corners c = corners(mesh, t);
        const dvec3 a = position(mesh, c[1]) - position(mesh, c[0]);
        const dvec3 b = position(mesh, c[2]) - position(mesh, c[0]);
        const dvec3 d = b - a;
        const double longest = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(d, d)});
        const bool different = c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
        if (glm::length(glm::cross(a, b)) > kFlat * longest || (different && may_open && may_open(c))) {
            std::copy(c.begin(), c.end(), mesh.indices.begin() + static_cast<std::ptrdiff_t>(kept * 3));
            ++kept;
        }
    }
    mesh.indices.resize(kept * 3);
    return count - kept;
}

VertexSources remove_unused_vertices(Mesh& mesh) {
    VertexSources sources;
    std::vector<std::uint32_t> place(mesh.vertices.size(), 0);
    for (const std::uint32_t index : mesh.indices) {
        place[index] = 1;
    }
    std::uint32_t kept = 0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (place[v] != 0) {
            mesh.vertices[kept] = mesh.vertices[v];
            sources.push_back(static_cast<std::uint32_t>(v));
            place[v] = kept++;
        }
    }
    mesh.vertices.resize(kept);
    mesh.vertices.shrink_to_fit();
    for (std::uint32_t& index : mesh.indices) {
        index = place[index];
    }
    return sources;
}

vec3 triangle_normal(const std::array<vec3, 3>& corners) {
    const dvec3 origin = corners[0];
    return direction(glm::cross(dvec3(corners[1]) - origin, dvec3(corners[2]) - origin));
}

VertexSources make_flat_normals(Mesh& mesh) {
    VertexSources sources = mesh.indices;
    std::vector<Vertex> vertices;
    vertices.reserve(mesh.indices.size());
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        const Corners c = corners(mesh, t);
        const vec3 normal = direction(area_vector(mesh, c));
        for (const std::uint32_t vertex : c) {
            vertices.push_back(mesh.vertices[vertex]);
            vertices.back().normal = normal == vec3(0) ? vec3(0, 0, 1) : normal;
        }
    }
    mesh.vertices = std::move(vertices);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        mesh.indices[i] = static_cast<std::uint32_t>(i);
    }
    return sources;
}

std::size_t mend_normals(Mesh& mesh) {
    std::vector<std::uint32_t> bad;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        vec3& normal = mesh.vertices[v].normal;
        normal = is_finite(normal) ? direction(normal) : vec3(0);
        if (normal == vec3(0)) {
            bad.push_back(static_cast<std::uint32_t>(v));
        }
    }
    if (bad.empty()) {
        return 0;
    }
    std::vector<dvec3> sums(mesh.vertices.size(), dvec3(0));
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        const Corners c = corners(mesh, t);
        for (const std::uint32_t vertex : c) {
            sums[vertex] += area_vector(mesh, c);
        }
    }
    for (const std::uint32_t vertex : bad) {
        const vec3 mean = direction(sums[vertex]);
        mesh.vertices[vertex].normal = mean == vec3(0) ? vec3(0, 0, 1) : mean;
    }
    return bad.size();
}

std::size_t mend_tangents(Mesh& mesh) {
    constexpr float kParallel = 0.9999f;
    std::size_t replaced = 0;
    for (Vertex& vertex : mesh.vertices) {
        const vec3 given = is_finite(vec3(vertex.tangent)) ? direction(vec3(vertex.tangent)) : vec3(0);
        const bool usable = given != vec3(0) && std::abs(glm::dot(given, vertex.normal)) < kParallel;
        const float sign = vertex.tangent.w < 0 ? -1.0f : 1.0f;
        replaced += !usable;
        vertex.tangent = vec4(usable ? given : perpendicular(vertex.normal), sign);
    }
    return replaced;
}

VertexSources generate_tangents(Mesh& mesh, std::uint32_t uv_set, bool may_split) {
    VertexSources sources = every_vertex(mesh);
    const std::vector<std::int8_t> side = split_mirrored(mesh, uv_set, may_split ? &sources : nullptr);
    std::vector<dvec3> sums(mesh.vertices.size(), dvec3(0));
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        const Corners c = corners(mesh, t);
        const double area = uv_area(mesh, c, uv_set);
        if (area == 0) {
            continue;
        }
        const dvec3 e1 = position(mesh, c[1]) - position(mesh, c[0]);
        const dvec3 e2 = position(mesh, c[2]) - position(mesh, c[0]);
        const double v0 = uv_of(mesh.vertices[c[0]], uv_set).y;
        const double v1 = uv_of(mesh.vertices[c[1]], uv_set).y - v0;
        const double v2 = uv_of(mesh.vertices[c[2]], uv_set).y - v0;
        const dvec3 along_u = (e1 * v2 - e2 * v1) * (area < 0 ? -1.0 : 1.0);
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec3 at = position(mesh, c[k]);
            const dvec3 normal = mesh.vertices[c[k]].normal;
            const vec3 to_next = direction(position(mesh, c[(k + 1) % 3]) - at);
            const vec3 to_last = direction(position(mesh, c[(k + 2) % 3]) - at);
            const double angle =
                std::acos(std::clamp(static_cast<double>(glm::dot(to_next, to_last)), -1.0, 1.0));
            const dvec3 projected = along_u - normal * glm::dot(normal, along_u);
            sums[c[k]] += dvec3(direction(projected)) * angle;
        }
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        mesh.vertices[v].tangent = vec4(direction(sums[v]), side[v] < 0 ? -1.0f : 1.0f);
    }
    mend_tangents(mesh);
    return sources;
}

void make_any_tangents(Mesh& mesh) {
    for (Vertex& vertex : mesh.vertices) {
        vertex.tangent = vec4(perpendicular(vertex.normal), 1);
    }
}

}  // namespace lanthorn
