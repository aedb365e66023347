#include "lanthorn/scene/extract.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/finite.h"
#include "engine/scene/clear_sky.h"
#include "engine/scene/described.h"
#include "engine/scene/scene_changes.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/light_sensor.h"
#include "lanthorn/scene/view.h"

namespace lanthorn {
namespace {

using ecs::Entity;
using ecs::Optional;
using ecs::Read;

dmat4 relative_to(const dmat4& m, const dvec3& origin) {
    dmat4 moved = m;
    moved[3] -= dvec4(origin, 0);
    return moved;
}

// The rotation of a node whose matrix has none left, from the rotations down to it.
glm::dquat rotation_of(const ecs::World& world, Entity e) {
    glm::dquat rotation(1, 0, 0, 0);
    for (int depth = 0; depth < 256; ++depth) {
        if (const LocalTransform* local = world.try_get<LocalTransform>(e)) {
            const glm::dquat own(local->value.rotation);
            const double length = glm::length(own);
            if (length > 0 && std::isfinite(length)) rotation = own / length * rotation;
        }
        const Parent* parent = world.try_get<Parent>(e);
        if (!parent) break;
        e = parent->entity;
    }
    return rotation;
}

const std::shared_ptr<const SceneAssets>& no_assets() {
    static const auto empty = std::make_shared<const SceneAssets>();
    return empty;
}

}  // namespace

const DeformedMesh* Extractor::Source::deformed_mesh(std::size_t k) const {
    return deformed && k < deformed->meshes.size() && deformed->meshes[k].vertices ? &deformed->meshes[k]
                                                                                   : nullptr;
}

dmat4 Extractor::Source::to_world(std::size_t k) const {
    return deformed_mesh(k) && deformed->skinned ? glm::translate(dmat4(1), deformed->skinned_at)
                                                 : transform->matrix;
}

namespace {

struct Thing {
    dvec3 lower, upper;
};

// The middle of the box around all things; or that of most things, by each axis, where they lie so far off it
// for their size (a room in a sky dome a thousand kilometres wide, off its centre) that fp32 would be too
// coarse for them.
dvec3 first_origin(std::span<const Thing> things, const dvec3& middle) {
    constexpr double kFar = 1024;  // sizes of the thing in the middle of the order of sizes
    std::vector<double> values(things.size());
    const auto median = [&](auto value) {
        std::ranges::transform(things, values.begin(), value);
        const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::ranges::nth_element(values, at);
        return *at;
    };
    dvec3 most;
    for (int axis = 0; axis < 3; ++axis) {
        most[axis] = median([&](const Thing& t) { return 0.5 * t.lower[axis] + 0.5 * t.upper[axis]; });
    }
    const double size = median([](const Thing& t) { return glm::length(t.upper - t.lower); });
    return glm::length(most - middle) > kFar * size ? most : middle;
}

}  // namespace

void Extractor::place_origin() {
    std::vector<Thing> things;
    dvec3 lower(std::numeric_limits<double>::infinity()), upper(-lower);
    for (const Part& part : parts_) {
        const Source& source = sources_[part.source];
        const DeformedMesh* deformed = source.deformed_mesh(part.place);
        const Aabb& box = deformed ? deformed->bounds : part.asset->bounds;
        if (box.empty() || !is_finite(box.lower) || !is_finite(box.upper)) {
            continue;
        }
        const dmat4 m = source.to_world(part.place);
        if (!is_finite(m)) {
            continue;
        }
        dvec3 low(m[3]), high(low);  // Arvo 1990
        for (int axis = 0; axis < 3; ++axis) {
            const dvec3 a = dvec3(m[axis]) * double(box.lower[axis]);
            const dvec3 b = dvec3(m[axis]) * double(box.upper[axis]);
            low += glm::min(a, b);
            high += glm::max(a, b);
        }
        lower = glm::min(lower, low);
        upper = glm::max(upper, high);
        if (!have_origin_) {
            things.push_back({low, high});
        }
    }
    if (!(lower.x <= upper.x)) return;
    const dvec3 centre = 0.5 * lower + 0.5 * upper;
    const double distance = glm::length(centre - origin_);
    if (!std::isfinite(distance)) return;
    if (!have_origin_) {
        origin_ = first_origin(things, centre);
    } else if (distance > kOriginReach * glm::length(upper - lower)) {
        origin_ = centre;
    }
    have_origin_ = true;
}

void Extractor::order_parts(const SceneAssets& assets, const ecs::World& world) {
    parts_.clear();
    for (std::uint32_t s = 0; s < sources_.size(); ++s) {
        const Source& source = sources_[s];
        for (std::uint32_t k = 0; k < source.meshes->meshes.size(); ++k) {
            const MeshHandle mesh = source.meshes->meshes[k];
            if (const Mesh* asset = assets.meshes.find(mesh)) {
                parts_.push_back({source.entity.index, mesh.slot, s, k, asset});
            } else {
                warnings_.push_back(described(world, source.entity) + ": mesh " + std::to_string(mesh.slot) +
                                    " of generation " + std::to_string(mesh.generation) +
                                    " has been released or never was; left out");
            }
        }
    }
    const auto before = [](const Part& a, const Part& b) {
        return std::pair(a.id, a.mesh) < std::pair(b.id, b.mesh);
    };
    if (!std::is_sorted(parts_.begin(), parts_.end(), before))
        std::stable_sort(parts_.begin(), parts_.end(), before);
}

void Extractor::add_instances(FrameScene& frame, const ecs::World& world) {
    frame.instances.reserve(parts_.size());
    for (const Part& part : parts_) {
        const Source& source = sources_[part.source];
        const Mesh& mesh = *part.asset;
        const DeformedMesh* deformed = source.deformed_mesh(part.place);
        const Aabb& bounds = deformed ? deformed->bounds : mesh.bounds;
        if (mesh.indices.empty() || bounds.empty()) continue;
        const mat4 transform(relative_to(source.to_world(part.place), origin_));
        const Aabb moved = transformed(bounds, transform);
        if (!is_finite(transform) || !is_finite(moved.lower) || !is_finite(moved.upper)) {
            warnings_.push_back(described(world, source.entity) +
                                ": its world transform is not finite; mesh " + std::to_string(part.mesh) +
                                " left out");
            continue;
        }
        Instance& instance = frame.instances.emplace_back();
        instance.id = part.id;
        instance.mesh = part.mesh;
        instance.generation = source.entity.generation;
        instance.transform = transform;
        instance.bounds = moved;
        frame.bounds.add(moved);
        if (deformed) {
            instance.version = deformed->version;
            instance.deformed = static_cast<std::uint32_t>(frame.deformed.size());
            frame.deformed.push_back(*deformed);
        }
    }
}

void Extractor::add_lights(FrameScene& frame, const ecs::World& world) {
    world.query<Read<LightComponent>, Read<WorldTransform>>().each(
        [&](Entity e, const LightComponent& component, const WorldTransform& transform) {
            LightInstance light;
            light.id = e.index;
            light.light = component.light;
            light.position = vec3(dvec3(transform.matrix[3]) - origin_);
            const bool sane = is_finite(light.position) && std::isfinite(component.light.intensity) &&
                              is_finite(component.light.colour) && !std::isnan(component.light.range);
            if (!sane || !is_finite(transform.matrix)) {
                warnings_.push_back(described(world, e) +
                                    ": the light's transform or strength is not finite; left out");
                return;
            }
            glm::dmat3 basis(1);
            if (orthonormal_basis(transform.matrix, basis)) {
                light.direction = glm::normalize(vec3(-basis[2]));
            } else {
                light.direction = glm::normalize(vec3(rotation_of(world, e) * dvec3(0, 0, -1)));
            }
            frame.lights.push_back(light);
        });
    std::sort(frame.lights.begin(), frame.lights.end(),
              [](const LightInstance& a, const LightInstance& b) { return a.id < b.id; });
}

void Extractor::add_sky(FrameScene& frame, const ecs::World& world) {
    world.query<Read<SkyComponent>, Read<WorldTransform>>().each(
        [&](Entity e, const SkyComponent& component, const WorldTransform& transform) {
            const Sky& sky = component.sky;
            glm::dmat3 basis(1);
            if (!is_finite(sky.colour) || !std::isfinite(sky.intensity) || !is_finite(transform.matrix) ||
                !orthonormal_basis(transform.matrix, basis)) {
                warnings_.push_back(described(world, e) +
                                    ": the sky's transform or strength is not finite; left out");
                return;
            }
            const bool black = !sky.image || !(sky.intensity > 0) || sky.colour == vec3(0);
            if (!black && (!frame.sky || e.index < frame.sky->id)) {
                frame.sky = SkyInstance{e.index, sky, mat3(glm::transpose(basis))};
            }
        });
    if (!frame.sky) {
        add_clear_sky(frame, world);
    }
    const Backdrop* backdrop = world.try_resource<Backdrop>();
    if (!frame.sky && backdrop != nullptr && backdrop->sky.image) {
        frame.sky = SkyInstance{kNone, backdrop->sky, mat3(1)};
    }
}

void Extractor::add_clear_sky(FrameScene& frame, const ecs::World& world) {
    world.query<Read<ClearSky>, Read<LightComponent>>().each([&](Entity e, const ClearSky& component,
                                                                 const LightComponent&) {
        const auto sun = std::ranges::lower_bound(frame.lights, e.index, {}, &LightInstance::id);
        if (sun == frame.lights.end() || sun->id != e.index || sun->light.type != LightType::directional ||
            !(sun->direction.y < 0) || (frame.sky && frame.sky->id < e.index)) {
            return;
        }
        const vec3 to_sun = -sun->direction;
        const float turbidity = std::clamp(component.turbidity, 2.0f, 10.0f);
        const Light of_that_day = clear_sun(to_sun, turbidity);
        const auto lux = [](const Light& light) {
            return luminance(dvec3(light.colour)) * static_cast<double>(light.intensity);
        };
        Sky sky;
        sky.intensity = component.intensity * static_cast<float>(lux(sun->light) / lux(of_that_day));
        if (!(sky.intensity > 0) || !std::isfinite(sky.intensity)) {
            return;
        }
        if (!clear_sky_ || clear_to_sun_ != to_sun || clear_turbidity_ != turbidity) {
            clear_sky_ = std::make_shared<const SkyImage>(clear_sky(to_sun, turbidity));
            clear_to_sun_ = to_sun;
            clear_turbidity_ = turbidity;
        }
        sky.image = clear_sky_;
        frame.sky = SkyInstance{e.index, std::move(sky), mat3(1)};
    });
}

void Extractor::add_sensors(FrameScene& frame, const ecs::World& world) {
    world.query<Read<LightSensor>, Read<WorldTransform>>().each(
        [&](Entity e, const LightSensor& sensor, const WorldTransform& transform) {
            const vec3 position(dvec3(transform.matrix[3]) - origin_);
            const dvec3 back(transform.matrix[2]);
            if (!is_finite(position) || !(glm::length(back) > 0) || !is_finite(vec3(back)) ||
                !(sensor.radius > 0) || !std::isfinite(sensor.radius)) {
                warnings_.push_back(
                    described(world, e) +
                    ": the light sensor's transform or radius is not as expected (finite, radius > 0);"
                    " left out");
                return;
            }
            frame.sensors.push_back(
                {e.index, position, vec3(-glm::normalize(back)), sensor.radius, sensor.filter});
        });
    std::sort(frame.sensors.begin(), frame.sensors.end(),
              [](const SensorInstance& a, const SensorInstance& b) { return a.id < b.id; });
}

FrameScene Extractor::gather(const ecs::World& world) {
    warnings_.clear();
    FrameScene frame;
    const AssetStore* store = world.try_resource<AssetStore>();
    frame.assets = store ? store->snapshot() : no_assets();
    sources_.clear();
    world.query<Read<MeshInstances>, Read<WorldTransform>, Optional<Read<DeformedMeshes>>>().each(
        [&](Entity e, const MeshInstances& meshes, const WorldTransform& transform,
            const DeformedMeshes* deformed) {
            sources_.push_back({e, &transform, &meshes, deformed});
        });
    order_parts(*frame.assets, world);
    place_origin();
    frame.frame = frames_++;
    frame.origin = origin_;
    add_instances(frame, world);
    add_lights(frame, world);
    add_sky(frame, world);
    add_sensors(frame, world);
    std::sort(warnings_.begin(), warnings_.end());
    return frame;
}

FrameScene Extractor::extract(const ecs::World& world, Entity camera, std::optional<float> y_fov) {
    FrameScene frame = gather(world);
    if (camera) {
        Camera lens = world.get<CameraComponent>(camera).camera;
        lens.y_fov = y_fov.value_or(lens.y_fov);
        const dmat4& transform = world.get<WorldTransform>(camera).matrix;
        frame.camera = camera_view(lens, transform, origin_);
        if (!is_finite(transform) || !is_finite(frame.camera.position)) {
            warnings_.push_back(described(world, camera) +
                                ": the camera's world transform is not finite; the whole scene is shown");
            frame.camera = frame_all(frame);
        }
    } else {
        frame.camera = frame_all(frame);
    }
    return finish(std::move(frame));
}

FrameScene Extractor::extract(const ecs::World& world, const Camera& camera, const dmat4& camera_to_world) {
    FrameScene frame = gather(world);
    frame.camera = camera_view(camera, camera_to_world, origin_);
    return finish(std::move(frame));
}

FrameScene Extractor::extract(const ecs::World& world, const CameraView& view) {
    FrameScene frame = gather(world);
    frame.camera = view;
    return finish(std::move(frame));
}

void Extractor::mark_static(FrameScene& frame, const std::vector<std::uint32_t>& earlier) {
    std::vector<std::uint32_t> unmoved(frame.instances.size(), 0);
    auto moved = frame.changes.moved.begin();
    for (std::size_t i = 0; i < unmoved.size(); ++i) {
        if (moved != frame.changes.moved.end() && *moved == i) {
            ++moved;
        } else {
            unmoved[i] = unmoved_[earlier[i]] + 1;
        }
        frame.instances[i].is_static = unmoved[i] >= kStaticAfter;
    }
    unmoved_ = std::move(unmoved);
}

FrameScene Extractor::finish(FrameScene frame) {
    const std::vector<std::uint32_t> earlier = earlier_instances(last_.instances, frame.instances);
    frame.changes = frame.frame == 0 ? all_changed(frame) : changes_between(last_, frame, earlier);
    mark_static(frame, earlier);
    last_.origin = frame.origin;
    last_.assets = frame.assets;
    last_.instances = frame.instances;
    last_.lights = frame.lights;
    last_.sky = frame.sky;
    last_.camera = frame.camera;
    return frame;
}

}  // namespace lanthorn
