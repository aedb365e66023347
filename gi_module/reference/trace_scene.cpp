#include "gi_module/reference/trace_scene.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gi_module/reference/material_table.h"
#include "gi_module/reference/ray_log.h"
#include "gi_module/reference/trace_filter.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/parallel.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::reference {

namespace {

// Embree's geometry masks: rays that ignore blended surfaces have only the first bit.
constexpr unsigned kSolidMask = 1;
constexpr unsigned kBlendedMask = 2 | 4 | 8;

// Rounding of a triangle's plane, of a point on it and of Embree's own test, in units of its largest
// coordinate: a few steps of 2^-23 each, and then some.
constexpr float kOffset = 0x1p-18f;

// What moves has its boxes fitted again, which costs less than its tree, and every so many times a tree
// again: boxes of what has turned or bent lie over each other.
constexpr std::uint32_t kMovesOfATree = 16;

mat3 normal_matrix(const mat3& m, float determinant) {
    // The cofactor matrix takes normals where the inverse transpose does, and exists for flattened objects
    // too.
    mat3 normal(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    float greatest = 0;
    for (int i = 0; i < 3; ++i) {
        const vec3 a = glm::abs(normal[i]);
        greatest = std::max({greatest, a.x, a.y, a.z});
    }
    return greatest > 0 ? normal * ((determinant < 0 ? -1.0f : 1.0f) / greatest) : normal;
}

TraceTriangle describe(const vec3 (&p)[3], float mirror, const vec3& fallback) {
    TraceTriangle result;
    const dvec3 a(p[0]), n = glm::cross(dvec3(p[1]) - a, dvec3(p[2]) - a);
    const double length = glm::length(n);
    const dvec3 unit = length > 0 ? n * (static_cast<double>(mirror) / length) : dvec3(fallback);
    result.normal = vec3(unit);
    result.plane = static_cast<float>(glm::dot(dvec3(result.normal), a));
    float extent = 0;
    for (const vec3& q : p) {
        extent = std::max({extent, std::abs(q.x), std::abs(q.y), std::abs(q.z)});
    }
    result.offset = std::max(extent * kOffset, std::numeric_limits<float>::min());
    return result;
}

// Fills in what stays of the vertices that are in use, in any pose.
std::unique_ptr<Mesh> mesh_to_pose(const InstanceShape& shape, const ReducedShape* reduced) {
    if (reduced == nullptr) {
        return shape.deformed() ? std::make_unique<Mesh>(posed_mesh(shape)) : nullptr;
    }
    auto mesh = std::make_unique<Mesh>();
    mesh->name = shape.mesh().name;
    mesh->material = shape.mesh().material;
    mesh->indices = reduced->indices;
    mesh->vertices.reserve(reduced->vertices.size());
    for (const std::uint32_t v : reduced->vertices) {
        mesh->vertices.push_back(shape.vertex(v));
        mesh->bounds.add(mesh->vertices.back().position);
    }
    return mesh;
}

void pose(Mesh& mesh, const DeformedMesh& deformed, const ReducedShape* reduced) {
    const std::vector<VertexFrame>& frames = *deformed.vertices;
    mesh.bounds = {};
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const VertexFrame& frame = frames[reduced != nullptr ? reduced->vertices[v] : v];
        mesh.vertices[v].position = frame.position;
        mesh.vertices[v].normal = frame.normal;
        mesh.vertices[v].tangent = frame.tangent;
        mesh.bounds.add(frame.position);
    }
}

const std::shared_ptr<const ReducedShape>& reduced_of(const ReducedShapes& reduced, std::size_t instance) {
    static const std::shared_ptr<const ReducedShape> none;
    return reduced.empty() ? none : reduced[instance];
}

}  // namespace

TraceScene::TraceScene(const FrameScene& scene, const MaterialTable& materials, Structure structure,
                       const ReducedShapes& reduced)
    : frame_(&scene), origin_(scene.origin) {
    device_ = rtcNewDevice(nullptr);
    if (device_ == nullptr) {
        throw InputError("path: Embree cannot be started on this processor");
    }
    scene_ = rtcNewScene(device_);
    // Robust: no leaks between triangles that share an edge. Dynamic and of low quality: a tree an instance,
    // each of medium quality, and one over them. Of another quality Embree 3 builds a single tree, of all
    // triangles, whenever one of them moves.
    const int flags = RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION |
                      (structure == Structure::moving ? RTC_SCENE_FLAG_DYNAMIC : RTC_SCENE_FLAG_NONE);
    rtcSetSceneFlags(scene_, static_cast<RTCSceneFlags>(flags));
    rtcSetSceneBuildQuality(scene_,
                            structure == Structure::moving ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_HIGH);
    instances_.resize(scene.instances.size());
    shapes_.resize(scene.instances.size());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        instances_[i].id = scene.instances[i].id;
        build(i, materials, reduced_of(reduced, i));
    }
    find_blended(materials);
    commit();
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
        throw InputError("path: Embree cannot hold this scene, expected fewer triangles or more memory");
    }
}

void TraceScene::commit() {
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    rtcCommitScene(scene_);
}

bool TraceScene::follow(const FrameScene& scene, const MaterialTable& materials,
                        const ReducedShapes& reduced) {
    const SceneChanges& changes = scene.changes;
    bool same = !changes.replaced && (admitted_ || changes.arrived.empty()) && scene.origin == origin_ &&
                scene.instances.size() == instances_.size();
    for (std::size_t i = 0; same && i < instances_.size(); ++i) {
        same = instances_[i].id == scene.instances[i].id;
    }
    if (!same) {
        return false;
    }
    frame_ = &scene;
    std::vector<bool> built(instances_.size(), false);
    bool altered = !changes.moved.empty() || admitted_;
    admitted_ = false;
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        if (shapes_[i].geometry == kNoGeometry ||
            !has_shape(shapes_[i], scene, scene.instances[i], reduced_of(reduced, i).get())) {
            build(i, materials, reduced_of(reduced, i));
            built[i] = altered = true;
        } else if (shapes_[i].posed == nullptr) {
            instances_[i].mesh = &scene.mesh(scene.instances[i]);  // assets may lie elsewhere now
        }
    }
    ecs::detail::parallel_for(changes.moved.size(), [&](std::size_t k) {
        const std::uint32_t i = changes.moved[k];
        if (!built[i]) {
            const RTCGeometry geometry = rtcGetGeometry(scene_, shapes_[i].geometry);
            const bool refit = ++shapes_[i].moves % kMovesOfATree != 0;
            rtcSetGeometryBuildQuality(geometry, refit ? RTC_BUILD_QUALITY_REFIT : RTC_BUILD_QUALITY_MEDIUM);
            place(i, materials, geometry);
            rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
            rtcCommitGeometry(geometry);
        }
    });
    find_blended(materials);
    if (altered) {
        commit();
    }
    return true;
}

bool TraceScene::has_shape(const Shape& shape, const FrameScene& scene, const Instance& instance,
                           const ReducedShape* reduced) {
    const InstanceShape now(scene, instance);
    const RefinedTopology* refined = now.deformed() ? now.deformed()->refined.get() : nullptr;
    return shape.mesh_version == scene.mesh_version(instance).any &&
           shape.deformed == (now.deformed() != nullptr) &&
           shape.refined == (refined != nullptr ? refined->serial : 0) && shape.reduced.get() == reduced;
}

void TraceScene::find_blended(const MaterialTable& materials) {
    has_blended_ = std::ranges::any_of(
        instances_, [&](const TraceInstance& instance) { return materials[instance.material].blend; });
}

void TraceScene::log_to(RayLog* log) {
    log_ = log;
    if (log != nullptr) {
        log->scene = scene_;
    }
}

TraceScene::~TraceScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

void TraceScene::build(std::size_t index, const MaterialTable& materials,
                       std::shared_ptr<const ReducedShape> reduced) {
    const Instance& instance = frame_->instances[index];
    const InstanceShape own(*frame_, instance);
    Shape& shape = shapes_[index];
    std::uint32_t number = shape.geometry;
    if (number != kNoGeometry) {
        rtcDetachGeometry(scene_, number);
    } else if (!unused_.empty()) {
        number = unused_.back();
        unused_.pop_back();
    } else {
        number = static_cast<std::uint32_t>(instance_of_.size());
        instance_of_.emplace_back();
    }
    instance_of_[number] = static_cast<std::uint32_t>(index);
    const DeformedMesh* deformed = own.deformed();
    shape = {.geometry = number,
             .mesh_version = frame_->mesh_version(instance).any,
             .refined = deformed != nullptr && deformed->refined ? deformed->refined->serial : 0,
             .deformed = deformed != nullptr,
             .reduced = std::move(reduced),
             .posed = nullptr,
             .filter = std::make_unique<FilterData>(
                 FilterData{&materials, this, static_cast<std::uint32_t>(index)})};
    shape.posed = mesh_to_pose(own, shape.reduced.get());
    const Mesh& mesh = shape.posed ? *shape.posed : own.mesh();
    const std::size_t count = mesh.indices.size() / 3;

    TraceInstance& placed = instances_[index];
    placed.mesh = &mesh;
    placed.coloured = std::ranges::any_of(mesh.vertices, [](const Vertex& v) { return v.colour != vec4(1); });
    placed.normals.resize(mesh.vertices.size());
    if (count > placed.triangle_places) {
        places_.give_back(placed.first_triangle, placed.triangle_places);
        placed.triangle_places = static_cast<std::uint32_t>(count);
        placed.first_triangle = place_for(placed.triangle_places);
    }

    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    const void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                    3 * sizeof(float), mesh.vertices.size());
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            3 * sizeof(std::uint32_t), count);
    if (positions == nullptr || indices == nullptr) {
        rtcReleaseGeometry(geometry);
        return;  // the device's error says it
    }
    std::copy_n(mesh.indices.begin(), 3 * count, static_cast<std::uint32_t*>(indices));
    place(index, materials, geometry);
    rtcSetGeometryUserData(geometry, shape.filter.get());
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, number);
    rtcReleaseGeometry(geometry);
}

void TraceScene::place(std::size_t index, const MaterialTable& materials, RTCGeometry geometry) {
    const Instance& instance = frame_->instances[index];
    const InstanceShape own(*frame_, instance);
    const Shape& shape = shapes_[index];
    if (shape.deformed) {
        pose(*shape.posed, *own.deformed(), shape.reduced.get());
    }
    const Mesh& mesh = shape.posed ? *shape.posed : own.mesh();
    const mat3 linear(instance.transform);
    const float determinant = glm::determinant(linear);
    TraceInstance& placed = instances_[index];
    placed.mesh = &mesh;
    placed.material = mesh.material;
    placed.to_render = linear;
    placed.mirror = determinant < 0 ? -1.0f : 1.0f;

    auto* positions = static_cast<float*>(rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_VERTEX, 0));
    shapes_[index].positions = positions;
    const mat3 normal_to_render = normal_matrix(linear, determinant);
    std::vector<vec3> placed_positions;
    placed_positions.reserve(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const vec3 p(instance.transform * vec4(mesh.vertices[i].position, 1));
        placed_positions.push_back(p);
        const vec3 normal = normal_to_render * mesh.vertices[i].normal;
        const float length = glm::length(normal);
        placed.normals[i] = length > 0 ? normal / length : vec3(0);
        *positions++ = p.x;
        *positions++ = p.y;
        *positions++ = p.z;
    }
    for (std::size_t i = 0; i < mesh.indices.size() / 3; ++i) {
        const std::uint32_t* v = &mesh.indices[3 * i];
        const vec3 p[3] = {placed_positions[v[0]], placed_positions[v[1]], placed_positions[v[2]]};
        const vec3& vertex_normal = placed.normals[v[0]];
        triangles_[placed.first_triangle + i] =
            describe(p, placed.mirror, vertex_normal != vec3(0) ? vertex_normal : vec3(0, 0, 1));
    }

    const MaterialConstants& material = materials[mesh.material];
    shape.filter->mask = material.mask;
    shape.filter->blend = material.blend;
    shape.filter->nearest = shape.reduced ? 2 * shape.reduced->error * instance.bounds.diagonal() : 0;
    rtcSetGeometryMask(geometry, material.blend ? kBlendedMask : kSolidMask);
    const bool filtered = material.mask || material.blend || shape.filter->nearest > 0;
    const RTCFilterFunctionN filter = filtered ? pass_left_out : nullptr;
    rtcSetGeometryIntersectFilterFunction(geometry, filter);
    rtcSetGeometryOccludedFilterFunction(geometry, filter);
}

}  // namespace lanthorn::reference
