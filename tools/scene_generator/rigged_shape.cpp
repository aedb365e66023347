#include "tools/scene_generator/rigged_shape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace lanthorn::scene_generator {

SkinInfluences JointChain::at(double y) const {
    std::vector<std::pair<double, std::uint16_t>> shares;
    double left = 1;
    for (std::size_t k = 0; k < joints.size(); ++k) {
        double below = 0;  // what the next joint takes of what is left
        if (k + 1 < joints.size()) {
            const double u = std::clamp((joints[k + 1].second + soft - y) / (2 * soft), 0.0, 1.0);
            below = u * u * (3 - 2 * u);
        }
        shares.emplace_back(left * (1 - below), joints[k].first);
        left *= below;
    }
    std::stable_sort(shares.begin(), shares.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    SkinInfluences result;
    for (std::size_t k = 0; k < std::min(shares.size(), SkinInfluences::kMost) && shares[k].first > 0; ++k) {
        result.joints[k] = shares[k].second;
        result.weights[k] = static_cast<float>(shares[k].first);
    }
    return result;
}

void RiggedShape::add_tube(const std::vector<Ring>& rings, int sides, const JointChain* chain) {
    std::vector<std::uint32_t> first;  // of each ring
    std::vector<int> count;
    for (const Ring& ring : rings) {
        first.push_back(static_cast<std::uint32_t>(positions.size()));
        count.push_back(ring.x == 0 && ring.z == 0 ? 1 : sides);
        for (int s = 0; s < count.back(); ++s) {
            const double angle = 2 * std::numbers::pi * s / sides;
            positions.push_back(ring.centre + dvec3(ring.x * std::cos(angle), 0, ring.z * std::sin(angle)));
            if (chain != nullptr) {
                influences.push_back(chain->at(positions.back().y));
            }
        }
    }
    for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
        for (int s = 0; s < sides; ++s) {
            const auto point = [&](std::size_t ring, int side) {
                return first[ring] + static_cast<std::uint32_t>(side % count[ring]);
            };
            const std::uint32_t a = point(r, s), b = point(r, s + 1), c = point(r + 1, s + 1),
                                d = point(r + 1, s);
            if (count[r] > 1) {
                indices.insert(indices.end(), {a, d, b});
            }
            if (count[r + 1] > 1) {
                indices.insert(indices.end(), {b, d, c});
            }
        }
    }
}

std::vector<Ring> capsule(const dvec3& low, const dvec3& high, double x_low, double x_high, double flat,
                          int middle, int cap) {
    std::vector<Ring> rings;
    const auto add = [&](double y, double x) {
        const double along = (y - low.y) / (high.y - low.y);
        const dvec3 centre = low + along * (high - low);
        rings.push_back({dvec3(centre.x, y, centre.z), x, x * flat});
    };
    for (int i = 0; i <= cap; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / cap;
        add(low.y + x_low * (1 - std::cos(angle)), i == 0 ? 0 : x_low * std::sin(angle));
    }
    const double from = low.y + x_low;
    const double to = high.y - x_high;
    for (int i = 1; i < middle; ++i) {
        const double along = static_cast<double>(i) / middle;
        add(from + along * (to - from), x_low + along * (x_high - x_low));
    }
    for (int i = cap; i >= 0; --i) {
        const double angle = 0.5 * std::numbers::pi * i / cap;
        add(high.y - x_high * (1 - std::cos(angle)), i == 0 ? 0 : x_high * std::sin(angle));
    }
    return rings;
}

std::vector<dvec3> smooth_normals(const std::vector<dvec3>& positions,
                                  const std::vector<std::uint32_t>& indices) {
    std::vector<dvec3> normals(positions.size(), dvec3(0));
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const dvec3& a = positions[indices[i]];
        const dvec3 area = glm::cross(positions[indices[i + 1]] - a, positions[indices[i + 2]] - a);
        for (std::size_t k = 0; k < 3; ++k) {
            normals[indices[i + k]] += area;
        }
    }
    for (dvec3& normal : normals) {
        normal = glm::normalize(normal);
    }
    return normals;
}

Mesh smooth_mesh(const std::string& name, const RiggedShape& shape, std::uint32_t material) {
    Mesh mesh;
    mesh.name = name;
    mesh.material = material;
    mesh.indices = shape.indices;
    mesh.skin = shape.influences;
    const std::vector<dvec3> normals = smooth_normals(shape.positions, shape.indices);
    for (std::size_t v = 0; v < shape.positions.size(); ++v) {
        Vertex vertex;
        vertex.position = shape.positions[v];
        vertex.normal = normals[v];
        mesh.vertices.push_back(vertex);
        mesh.bounds.add(vertex.position);
    }
    return mesh;
}

Mesh edged_mesh(const std::string& name, const RiggedShape& shape, std::uint32_t material) {
    constexpr double kSmooth = 0.82, kFair = 0.92;  // cosines: of faces with each other, with the normal
    std::vector<dvec3> areas;                       // of faces, along their normals
    std::vector<std::vector<std::size_t>> faces_at(shape.positions.size());
    for (std::size_t f = 0; 3 * f < shape.indices.size(); ++f) {
        const dvec3& a = shape.positions[shape.indices[3 * f]];
        areas.push_back(glm::cross(shape.positions[shape.indices[3 * f + 1]] - a,
                                   shape.positions[shape.indices[3 * f + 2]] - a));
        for (std::size_t k = 0; k < 3; ++k) {
            faces_at[shape.indices[3 * f + k]].push_back(f);
        }
    }
    const auto normal_of = [&](std::size_t face, std::uint32_t point) {
        const dvec3 own = glm::normalize(areas[face]);
        dvec3 sum(0);
        for (const std::size_t other : faces_at[point]) {
            if (glm::dot(own, glm::normalize(areas[other])) > kSmooth) {
                sum += areas[other];
            }
        }
        sum = glm::normalize(sum);
        return glm::dot(own, sum) > kFair ? sum : own;
    };
    Mesh mesh;
    mesh.name = name;
    mesh.material = material;
    std::map<std::tuple<std::uint32_t, float, float, float>, std::uint32_t> made;
    for (std::size_t i = 0; i < shape.indices.size(); ++i) {
        const std::uint32_t point = shape.indices[i];
        const vec3 normal(normal_of(i / 3, point));
        const auto [found, is_new] = made.try_emplace({point, normal.x, normal.y, normal.z},
                                                      static_cast<std::uint32_t>(mesh.vertices.size()));
        if (is_new) {
            Vertex vertex;
            vertex.position = shape.positions[point];
            vertex.normal = normal;
            mesh.vertices.push_back(vertex);
            if (!shape.influences.empty()) {
                mesh.skin.push_back(shape.influences[point]);
            }
            mesh.bounds.add(vertex.position);
        }
        mesh.indices.push_back(found->second);
    }
    return mesh;
}

void add_hanging_face(Mesh& mesh, const std::array<dvec3, 4>& corners, const JointChain& hang) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const dvec3 normal = glm::normalize(glm::cross(corners[2] - corners[0], corners[3] - corners[1]));
    for (const dvec3& p : corners) {
        Vertex vertex;
        vertex.position = p;
        vertex.normal = normal;
        mesh.vertices.push_back(vertex);
        mesh.skin.push_back(hang.at(p.y));
        mesh.bounds.add(vertex.position);
    }
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) {
        mesh.indices.push_back(first + i);
    }
    mesh.cage->face_sizes.push_back(4);
}

MorphTarget morph_target(const RiggedShape& shape, const std::vector<dvec3>& moved) {
    const std::vector<dvec3> before = smooth_normals(shape.positions, shape.indices);
    const std::vector<dvec3> after = smooth_normals(moved, shape.indices);
    MorphTarget target;
    for (std::size_t v = 0; v < moved.size(); ++v) {
        const dvec3 position = moved[v] - shape.positions[v];
        const dvec3 normal = after[v] - before[v];
        if (glm::length(position) < 1e-5 && glm::length(normal) < 1e-3) {
            continue;  // less than one sees
        }
        target.vertices.push_back(static_cast<std::uint32_t>(v));
        target.positions.push_back(vec3(position));
        target.normals.push_back(vec3(normal));
    }
    return target;
}

}  // namespace lanthorn::scene_generator
