#include "engine/assets/scene_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace lanthorn {

namespace {

double half_surface(const dvec3& size) {
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

double triangle_area(const Mesh& mesh, std::size_t first) {
    const auto at = [&](std::size_t c) { return dvec3(mesh.vertices[mesh.indices[first + c]].position); };
    return glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2;
}

// The area of what is left.
double cut_mesh(Mesh& mesh, std::vector<std::string>& warnings) {
    const double most = kMostLayers * half_surface(dvec3(mesh.bounds.upper) - dvec3(mesh.bounds.lower));
    double area = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const double own = triangle_area(mesh, i);
        if (area + own > most && i > 0 && !mesh.cage) {
            warnings.push_back(
                fmt::format("mesh '{}': its triangles lie in more than {} layers; {} of {} are left out",
                            mesh.name, kMostLayers, (mesh.indices.size() - i) / 3, mesh.indices.size() / 3));
            mesh.indices.resize(i);
            break;
        }
        area += own;
    }
    return area;
}

struct Placed {
    double area = 0, half_surface = 0;  // square metres
    std::array<int, 4> place{};  // those that agree in it stand in the same place, to an eighth of their size
    dvec3 lower{0}, upper{0};
};

Placed placed(const Mesh& mesh, double area, const dmat4& world) {
    std::array<double, 3> scale{glm::length(dvec3(world[0])), glm::length(dvec3(world[1])),
                                glm::length(dvec3(world[2]))};
    std::ranges::sort(scale);
    Placed result;
    result.area = area * scale[1] * scale[2];
    result.lower = dvec3(std::numeric_limits<double>::max());
    result.upper = -result.lower;
    for (int corner = 0; corner < 8; ++corner) {
        const Aabb& box = mesh.bounds;
        const dvec3 point(world * dvec4(corner & 1 ? box.upper.x : box.lower.x,
                                        corner & 2 ? box.upper.y : box.lower.y,
                                        corner & 4 ? box.upper.z : box.lower.z, 1));
        result.lower = glm::min(result.lower, point);
        result.upper = glm::max(result.upper, point);
    }
    const dvec3 size = result.upper - result.lower;
    result.half_surface = half_surface(size);
    const int magnitude = std::ilogb(std::max(glm::length(size), 1e-30));
    const dvec3 cell = glm::floor(0.5 * (result.lower + result.upper) / std::ldexp(0.125, magnitude));
    for (int axis = 0; axis < 3; ++axis) {
        result.place[static_cast<std::size_t>(axis)] = static_cast<int>(std::clamp(cell[axis], -2e9, 2e9));
    }
    result.place[3] = magnitude;
    return result;
}

}  // namespace

void cut_to_budget(SceneData& scene) {
    std::vector<double> areas;
    for (Mesh& mesh : scene.meshes) {
        areas.push_back(cut_mesh(mesh, scene.warnings));
    }
    std::vector<dmat4> worlds;
    std::vector<std::pair<Placed, std::uint64_t>> all;  // with triangles; in the order of nodes and meshes
    dvec3 lower(std::numeric_limits<double>::max()), upper = -lower;
    for (const NodeData& node : scene.nodes) {
        const dmat4 local = node.local.matrix() * dmat4(glm::dmat3(node.shear));
        worlds.push_back(node.parent == kNone ? local : worlds[node.parent] * local);
        for (const std::uint32_t mesh : node.meshes) {
            all.emplace_back(placed(scene.meshes[mesh], areas[mesh], worlds.back()),
                             scene.meshes[mesh].indices.size() / 3);
            lower = glm::min(lower, all.back().first.lower);
            upper = glm::max(upper, all.back().first.upper);
        }
    }
    const double whole = half_surface(upper - lower);
    std::map<std::array<int, 4>, double> layers;  // by place
    double area = 0;
    std::uint64_t triangles = 0;
    std::size_t at = 0, same_place = 0, too_much = 0;
    for (NodeData& node : scene.nodes) {
        std::erase_if(node.meshes, [&](std::uint32_t) {
            const auto& [own, count] = all[at++];
            double& here = layers[own.place];
            const double more = own.half_surface > 0 ? own.area / own.half_surface : 0;
            if (here > 0 && here + more > kMostLayers) {
                ++same_place;
                return true;
            }
            if (triangles > 0 &&
                (triangles + count > kMostPlacedTriangles || area + own.area > kMostLayers * whole)) {
                ++too_much;
                return true;
            }
            here += more;
            area += own.area;
            triangles += count;
            return false;
        });
    }
    if (same_place > 0) {
        scene.warnings.push_back(fmt::format(
            "nodes: {} instances stand where there are {} layers of surface already; they are left out",
            same_place, kMostLayers));
    }
    if (too_much > 0) {
        scene.warnings.push_back(
            fmt::format("nodes: {} instances are left out: a scene may have {} triangles, and "
                        "{} layers of surface on average",
                        too_much, kMostPlacedTriangles, kMostLayers));
    }
}

}  // namespace lanthorn
