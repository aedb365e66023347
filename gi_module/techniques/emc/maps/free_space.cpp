#include "gi_module/techniques/emc/maps/free_space.h"

#include <algorithm>
#include <cmath>

#include "gi_module/techniques/emc/maps/instance_key.h"

namespace lanthorn::gi {

namespace {

constexpr double kCells = 1 << 20;

bool takes_space(const FrameScene& scene, const Instance& instance) {
    const Material& material = scene.material(instance);
    return instance.deformed == Instance::kNotDeformed && material.alpha_mode != AlphaMode::blend &&
           material.transmission < 0.5f;
}

// The octants of directions, a bit each (1 for +x, 2 for +y, 4 for +z), some of which run against `normal`;
// all of them for triangles with two fronts.
std::uint8_t octants_against(const vec3& normal, bool double_sided) {
    constexpr float kFlat = 1e-4f;  // of its length: rounding of a normal along an axis
    std::uint8_t result = 0;
    for (int octant = 0; octant < 8; ++octant) {
        bool against = double_sided;
        for (int axis = 0; axis < 3; ++axis) {
            const float sign = (octant >> axis & 1) != 0 ? 1.0f : -1.0f;
            against = against || sign * normal[axis] < -kFlat * glm::length(normal);
        }
        result |= static_cast<std::uint8_t>(against ? 1 << octant : 0);
    }
    return result;
}

int octant_of(const vec3& direction) {
    return (direction.x >= 0 ? 1 : 0) | (direction.y >= 0 ? 2 : 0) | (direction.z >= 0 ? 4 : 0);
}

// A triangle against cells: its plane, its box, and its edges seen along each axis (Schwarz and Seidel 2010).
struct CellTest {
    CellTest(const vec3& a, const vec3& b, const vec3& c, float side) {
        const vec3 corners[3] = {a, b, c};
        const vec3 n = glm::cross(b - a, c - a);
        normal = n;
        plane = glm::dot(n, a);
        reach = 0.5f * side * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const float turn = n[axis] < 0 ? -1.0f : 1.0f;
            for (int e = 0; e < 3; ++e) {
                const vec3 &p = corners[e], &q = corners[(e + 1) % 3];
                const glm::vec2 inwards(turn * (p[v] - q[v]), turn * (q[u] - p[u]));
                edges[axis][e] = {inwards, 0.5f * side * (std::abs(inwards.x) + std::abs(inwards.y)) -
                                               inwards.x * p[u] - inwards.y * p[v]};
            }
        }
    }
    bool touches(const vec3& middle) const {
        if (std::abs(glm::dot(normal, middle) - plane) > reach) {
            return false;
        }
        for (int axis = 0; axis < 3; ++axis) {
            const glm::vec2 p(middle[(axis + 1) % 3], middle[(axis + 2) % 3]);
            for (const Edge& edge : edges[axis]) {
                if (glm::dot(edge.inwards, p) + edge.offset < 0) {
                    return false;
                }
            }
        }
        return true;
    }

    struct Edge {
        glm::vec2 inwards{0};
        float offset = 0;
    };
    vec3 normal{0};
    float plane = 0, reach = 0;
    Edge edges[3][3];
};

}  // namespace

FreeSpace::FreeSpace(const FrameScene& scene, const Aabb& bounds) {
    const vec3 size = glm::max(bounds.size(), vec3(1e-3f * bounds.diagonal()));
    lower_ = bounds.centre() - 0.5f * size;
    side_ = static_cast<float>(std::cbrt(double(size.x) * double(size.y) * double(size.z) / kCells));
    side_ = std::max(side_, std::max({size.x, size.y, size.z}) / 1024);
    cells_ = glm::max(ivec3(glm::ceil(size / side_)), ivec3(1));
    taken_.assign(index(cells_ - 1) + 1, 0);
    fronts_.assign(taken_.size(), 0);
    for (const Instance& instance : scene.instances) {
        if (takes_space(scene, instance)) {
            placed_[instance_key(instance)] = instance.transform;
            fill(InstanceShape(scene, instance), instance.transform, scene.material(instance).double_sided,
                 1);
        }
    }
}

void FreeSpace::fill(const InstanceShape& shape, const mat4& transform, bool double_sided, int change) {
    const float winding = glm::determinant(mat3(transform)) < 0 ? -1.0f : 1.0f;
    std::vector<vec3> points(shape.vertex_count());
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = vec3(transform * vec4(shape.position(i), 1));
    }
    const std::span<const std::uint32_t> indices = shape.indices();
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const vec3 &a = points[indices[i]], &b = points[indices[i + 1]], &c = points[indices[i + 2]];
        const CellTest test(a, b, c, side_);
        const std::uint8_t fronts = octants_against(winding * test.normal, double_sided);
        const ivec3 first = glm::max(cell_of(glm::min(a, glm::min(b, c))), ivec3(0));
        const ivec3 last = glm::min(cell_of(glm::max(a, glm::max(b, c))), cells_ - 1);
        for (int z = first.z; z <= last.z; ++z) {
            for (int y = first.y; y <= last.y; ++y) {
                for (int x = first.x; x <= last.x; ++x) {
                    if (test.touches(middle({x, y, z}))) {
                        std::uint16_t& taken = taken_[index({x, y, z})];
                        taken = static_cast<std::uint16_t>(std::clamp(taken + change, 0, 0xffff));
                        std::uint8_t& cell_fronts = fronts_[index({x, y, z})];
                        cell_fronts = taken == 0 ? 0 : static_cast<std::uint8_t>(cell_fronts | fronts);
                    }
                }
            }
        }
    }
}

template <typename Blocks>
bool FreeSpace::way_is_free(const vec3& a, const vec3& b, float slack, const Blocks& blocks) const {
    const float length = glm::distance(a, b);
    const int steps = std::max(1, static_cast<int>(std::ceil(2 * length / side_)));
    for (int i = 0; i <= steps; ++i) {
        const float at = length * static_cast<float>(i) / static_cast<float>(steps);
        const ivec3 cell = cell_of(glm::mix(a, b, static_cast<float>(i) / static_cast<float>(steps)));
        if (at >= slack && at <= length - slack && !free(cell) && blocks(index(cell))) {
            return false;
        }
    }
    return true;
}

bool FreeSpace::in_sight(const vec3& a, const vec3& b, float slack) const {
    return way_is_free(a, b, slack, [](std::size_t) { return true; });
}

bool FreeSpace::eye_sees(const vec3& eye, const vec3& p, float slack) const {
    const int octant = octant_of(p - eye);
    return way_is_free(eye, p, slack, [&](std::size_t cell) { return (fronts_[cell] >> octant & 1) != 0; });
}

bool FreeSpace::leave_out(const FrameScene& scene, std::span<const std::uint32_t> moved) {
    bool any = false;
    for (const std::uint32_t i : moved) {
        const Instance& instance = scene.instances[i];
        const auto stood = placed_.find(instance_key(instance));
        if (stood != placed_.end()) {
            fill(InstanceShape(scene.mesh(instance)), stood->second, scene.material(instance).double_sided,
                 -1);
            placed_.erase(stood);
            any = true;
        }
    }
    return any;
}

void FreeSpace::carry(const vec3& by) {
    lower_ += by;
    for (auto& [thing, transform] : placed_) {
        transform[3] += vec4(by, 0);
    }
}

std::vector<std::uint8_t> FreeSpace::clearance(int most) const {
    std::vector<std::uint8_t> steps(taken_.size());
    std::ranges::transform(taken_, steps.begin(), [&](std::uint16_t taken) {
        return static_cast<std::uint8_t>(taken > 0 ? 0 : most);
    });
    const auto spread = [&](const ivec3& from, const ivec3& to) {
        std::uint8_t& s = steps[index(to)];
        s = static_cast<std::uint8_t>(std::min<int>(s, steps[index(from)] + 1));
    };
    for (int axis = 0; axis < 3; ++axis) {
        ivec3 next(0);
        next[axis] = 1;
        const ivec3 end = cells_ - next;
        for (int pass = 0; pass < 2; ++pass) {
            for (int z = 0; z < end.z; ++z) {
                for (int y = 0; y < end.y; ++y) {
                    for (int x = 0; x < end.x; ++x) {
                        const ivec3 c = pass == 0 ? ivec3(x, y, z) : end - 1 - ivec3(x, y, z);
                        pass == 0 ? spread(c, c + next) : spread(c + next, c);
                    }
                }
            }
        }
    }
    return steps;
}

}  // namespace lanthorn::gi
