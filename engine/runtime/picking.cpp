#include "lanthorn/runtime/picking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

#include "engine/runtime/cut_out.h"
#include "engine/runtime/triangle_ray.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn {

namespace {

using ecs::Read;
using ecs::With;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// In render space.
struct Looked {
    dvec3 origin;
    const PickRay& ray;
};

bool touches(const Looked& looked, const Aabb& box) {
    double enter = looked.ray.nearest, leave = looked.ray.farthest;
    // Floats hold the box: rounded outwards, so that what lies in its faces is met.
    const double slack = 1e-6 * (static_cast<double>(box.diagonal()) + glm::length(dvec3(box.centre())));
    for (int axis = 0; axis < 3; ++axis) {
        const double from = static_cast<double>(box.lower[axis]) - slack - looked.origin[axis];
        const double to = static_cast<double>(box.upper[axis]) + slack - looked.origin[axis];
        const double along = looked.ray.direction[axis];
        if (along == 0) {
            if (from > 0 || to < 0) {
                return false;
            }
            continue;
        }
        enter = std::max(enter, std::min(from / along, to / along));
        leave = std::min(leave, std::max(from / along, to / along));
    }
    return enter <= leave;
}

// The instance's nearest triangle; its entity is still to be found.
std::optional<Picked> meet(const FrameScene& scene, const Instance& instance, const Looked& looked,
                           const TriangleRay& triangles) {
    const InstanceShape shape(scene, instance);
    const Material& material = scene.material(instance);
    const dmat4 transform(instance.transform);
    const bool mirrored = glm::determinant(glm::dmat3(transform)) < 0;
    const auto indices = shape.indices();
    const auto corner = [&](std::size_t k) {
        return dvec3(transform * dvec4(shape.position(indices[k]), 1)) - looked.origin;
    };
    Picked nearest;
    nearest.distance = looked.ray.farthest;
    bool found = false;
    for (std::size_t t = 0; 3 * t < indices.size(); ++t) {
        const dvec3 a = corner(3 * t), b = corner(3 * t + 1), c = corner(3 * t + 2);
        const auto hit = triangles.meet(a, b, c);
        if (!hit || hit->distance < looked.ray.nearest || hit->distance > nearest.distance ||
            (!material.double_sided && hit->counter_clockwise == mirrored) ||
            is_cut_out(scene, shape, material, t, vec3(hit->barycentric))) {
            continue;
        }
        found = true;
        nearest.distance = hit->distance;
        nearest.triangle = static_cast<std::uint32_t>(t);
        nearest.normal = glm::cross(b - a, c - a);
    }
    if (!found) {
        return std::nullopt;
    }
    nearest.mesh = instance.mesh;
    const double length = glm::length(nearest.normal);
    nearest.normal *=
        (glm::dot(nearest.normal, looked.ray.direction) > 0 ? -1 : 1) / (length > 0 ? length : 1);
    return nearest;
}

// Where the ray enters the sphere that stands for something at `centre`.
std::optional<double> meet_icon(const Looked& looked, const dvec3& centre, const PickOptions& options) {
    const PickRay& ray = looked.ray;
    const dvec3 to = centre - looked.origin;
    const double away = glm::length(to);
    const double radius =
        std::max(options.icon_metres, options.icon_pixels * (ray.pixel_spread * away + ray.pixel_width));
    const double along = glm::dot(to, ray.direction);
    const double beside = glm::length(to - along * ray.direction);
    const double enter = along - std::sqrt(std::max(radius * radius - beside * beside, 0.0));
    if (away <= radius || beside > radius || enter < ray.nearest || enter > ray.farthest) {
        return std::nullopt;
    }
    return enter;
}

// Gives what was found of a kind the generation of the entity that has its index and a T; what has none is
// dropped. O(entities with a T), and none where nothing was found.
template <class T>
void name_entities(const ecs::World& world, PickedKind kind, std::vector<Picked>& found) {
    std::unordered_map<std::uint32_t, ecs::Entity> wanted;
    for (const Picked& hit : found) {
        if (hit.kind == kind) {
            wanted.emplace(hit.entity.index, ecs::kNullEntity);
        }
    }
    if (wanted.empty()) {
        return;
    }
    world.query<With<T>>().each([&](ecs::Entity e) {
        if (const auto at = wanted.find(e.index); at != wanted.end()) {
            at->second = e;
        }
    });
    for (Picked& hit : found) {
        if (hit.kind == kind) {
            hit.entity = wanted.at(hit.entity.index);
        }
    }
    std::erase_if(found, [](const Picked& hit) { return !hit.entity; });
}

}  // namespace

PickRay pick_ray(const CameraView& look, const dvec3& origin, ivec2 size, const glm::dvec2& pixel) {
    const Camera& camera = look.camera;
    const glm::dmat3 axes = glm::transpose(glm::dmat3(look.view));  // columns: the camera's, in render space
    const double half = camera.orthographic ? static_cast<double>(camera.y_mag)
                                            : std::tan(0.5 * static_cast<double>(camera.y_fov));
    const double a_pixel = 2 * half / size.y;
    const dvec3 beside =
        axes[0] * (a_pixel * (pixel.x - 0.5 * size.x)) + axes[1] * (a_pixel * (0.5 * size.y - pixel.y));
    PickRay ray;
    ray.origin = origin + dvec3(look.position);
    double slant = 1;  // lengths of the ray in a metre along the camera's axis
    if (camera.orthographic) {
        ray.origin += beside;
        ray.direction = -axes[2];
        ray.pixel_width = a_pixel;
    } else {
        slant = glm::length(beside - axes[2]);
        ray.direction = (beside - axes[2]) / slant;
        ray.pixel_spread = a_pixel;
    }
    ray.nearest = slant * static_cast<double>(camera.z_near);
    if (camera.orthographic) {  // perspective pictures have no end
        const bool ends = camera.z_far > camera.z_near;
        ray.farthest = ends ? static_cast<double>(camera.z_far) : ray.nearest + 1000 * half;
    }
    return ray;
}

std::vector<Picked> pick(const ecs::World& world, const FrameScene& scene, const PickRay& ray,
                         const PickOptions& options) {
    const Looked looked{ray.origin - scene.origin, ray};
    std::vector<Picked> found;
    if (options.shapes) {
        const TriangleRay triangles(ray.direction);
        for (const Instance& instance : scene.instances) {
            if (!touches(looked, instance.bounds)) {
                continue;
            }
            if (auto hit = meet(scene, instance, looked, triangles)) {
                hit->entity.index = instance.id;
                found.push_back(*hit);
            }
        }
        name_entities<MeshInstances>(world, PickedKind::shape, found);
    }
    const auto add_icon = [&](PickedKind kind, ecs::Entity entity, const dvec3& centre) {
        if (const auto distance = meet_icon(looked, centre, options)) {
            Picked icon;
            icon.kind = kind;
            icon.entity = entity;
            icon.distance = *distance;
            found.push_back(icon);
        }
    };
    if (options.lights) {
        for (const LightInstance& light : scene.lights) {
            add_icon(PickedKind::light, {light.id, 0}, dvec3(light.position));
        }
        name_entities<LightComponent>(world, PickedKind::light, found);
    }
    if (options.cameras) {
        world.query<With<CameraComponent>, Read<WorldTransform>>().each(
            [&](ecs::Entity e, const WorldTransform& at) {
                if (e != options.through) {
                    add_icon(PickedKind::camera, e, dvec3(at.matrix[3]) - scene.origin);
                }
            });
    }
    for (Picked& hit : found) {
        hit.position = ray.origin + hit.distance * ray.direction;
    }
    std::ranges::stable_sort(found, {}, &Picked::distance);
    return found;
}

std::vector<Picked> pick(App& app, ViewId view, const glm::dvec2& pixel, PickOptions options) {
    const ecs::World& world = app.world();
    const DrawnView& drawn = world.resource<Renderer>().drawn(view);
    const FrameScene& scene = drawn.own ? *drawn.own : world.resource<FrameScene>();
    const View& shown = app.view(view);
    if (!options.through && !shown.placed) {
        options.through = shown.camera;
    }
    return pick(world, scene, pick_ray(scene.camera, scene.origin, drawn.frame->size(), pixel), options);
}

}  // namespace lanthorn
