#include "lanthorn/reference/trace_scene.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lanthorn/core/error.h"
#include "lanthorn/reference/material_table.h"
#include "lanthorn/reference/ray_log.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::reference {

namespace {

// Embree's geometry masks: rays that ignore blended surfaces have only the first bit.
constexpr unsigned kSolidMask = 1;
constexpr unsigned kBlendedMask = 2;

// Rounding of a triangle's plane, of a point on it and of Embree's own test, in units of its largest
// coordinate: a few steps of 2^-23 each, and then some.
constexpr float kOffset = 0x1p-18f;

// A shadow ray to a light ends this share short of it: what touches the light does not hide it.
constexpr float kShadowEnd = 1.0f - 1e-5f;

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

}  // namespace

struct TraceScene::FilterData {
    const MaterialTable* materials;
    const TraceScene* scene;
    std::uint32_t instance;
};

TraceScene::TraceScene(const FrameScene& scene, const MaterialTable& materials, Structure structure)
    : frame_(&scene), origin_(scene.origin) {
    device_ = rtcNewDevice(nullptr);
    if (device_ == nullptr) {
        throw InputError("path: Embree cannot be started on this processor");
    }
    scene_ = rtcNewScene(device_);
    // Robust: no leaks between triangles that share an edge. Dynamic: a tree an instance and one over them.
    const int flags = RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION |
                      (structure == Structure::moving ? RTC_SCENE_FLAG_DYNAMIC : RTC_SCENE_FLAG_NONE);
    rtcSetSceneFlags(scene_, static_cast<RTCSceneFlags>(flags));
    rtcSetSceneBuildQuality(
        scene_, structure == Structure::moving ? RTC_BUILD_QUALITY_MEDIUM : RTC_BUILD_QUALITY_HIGH);
    instances_.reserve(scene.instances.size());
    for (const Instance& instance : scene.instances) {
        add_instance(instance, materials);
    }
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

bool TraceScene::follow(const FrameScene& scene, const MaterialTable& materials) {
    const SceneChanges& changes = scene.changes;
    bool same = !changes.replaced && changes.arrived.empty() && scene.origin == origin_ &&
                scene.instances.size() == instances_.size();
    for (std::size_t i = 0; same && i < instances_.size(); ++i) {
        const InstanceShape shape(scene, scene.instances[i]);
        const TraceInstance& before = instances_[i];
        same = before.id == scene.instances[i].id &&
               (shape.deformed() != nullptr) == (posed_[i] != nullptr) &&
               shape.indices().size() == before.index_count && shape.vertex_count() == before.normals.size();
    }
    if (!same) {
        return false;
    }
    frame_ = &scene;
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        if (posed_[i] == nullptr) {
            instances_[i].mesh = &scene.mesh(scene.instances[i]);  // assets may lie elsewhere now
        }
    }
    for (const std::uint32_t i : changes.moved) {
        const RTCGeometry geometry = rtcGetGeometry(scene_, i);
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_REFIT);
        place(i, materials, geometry);
        rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
        rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0);
        rtcCommitGeometry(geometry);
    }
    has_blended_ = std::ranges::any_of(
        instances_, [&](const TraceInstance& instance) { return materials[instance.material].blend; });
    if (!changes.moved.empty()) {
        commit();
    }
    return true;
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

void TraceScene::add_instance(const Instance& instance, const MaterialTable& materials) {
    const InstanceShape shape(*frame_, instance);
    const std::size_t count = shape.indices().size() / 3;
    const std::size_t index = instances_.size();
    TraceInstance& placed = instances_.emplace_back();
    placed.id = instance.id;
    placed.index_count = shape.indices().size();
    placed.first_triangle = static_cast<std::uint32_t>(triangles_.size());
    placed.normals.resize(shape.vertex_count());
    triangles_.resize(triangles_.size() + count);
    posed_.push_back(shape.deformed() ? std::make_unique<Mesh>() : nullptr);
    filter_data_.push_back(
        std::make_unique<FilterData>(FilterData{&materials, this, static_cast<std::uint32_t>(index)}));

    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    const void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                    3 * sizeof(float), shape.vertex_count());
    const void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                  3 * sizeof(std::uint32_t), count);
    if (positions == nullptr || indices == nullptr) {
        rtcReleaseGeometry(geometry);
        return;  // the device's error says it
    }
    place(index, materials, geometry);
    rtcSetGeometryUserData(geometry, filter_data_.back().get());
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, static_cast<unsigned>(index));
    rtcReleaseGeometry(geometry);
}

void TraceScene::place(std::size_t index, const MaterialTable& materials, RTCGeometry geometry) {
    const Instance& instance = frame_->instances[index];
    const InstanceShape shape(*frame_, instance);
    if (shape.deformed()) {
        *posed_[index] = posed_mesh(shape);
    }
    const Mesh& mesh = shape.deformed() ? *posed_[index] : shape.mesh();
    const mat3 linear(instance.transform);
    const float determinant = glm::determinant(linear);
    TraceInstance& placed = instances_[index];
    placed.mesh = &mesh;
    placed.material = mesh.material;
    placed.to_render = linear;
    placed.mirror = determinant < 0 ? -1.0f : 1.0f;
    placed.coloured = std::ranges::any_of(mesh.vertices, [](const Vertex& v) { return v.colour != vec4(1); });

    auto* positions = static_cast<float*>(rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_VERTEX, 0));
    auto* indices = static_cast<std::uint32_t*>(rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_INDEX, 0));
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
    const std::size_t count = mesh.indices.size() / 3;
    std::copy_n(mesh.indices.begin(), 3 * count, indices);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t* v = &mesh.indices[3 * i];
        const vec3 p[3] = {placed_positions[v[0]], placed_positions[v[1]], placed_positions[v[2]]};
        const vec3& vertex_normal = placed.normals[v[0]];
        triangles_[placed.first_triangle + i] =
            describe(p, placed.mirror, vertex_normal != vec3(0) ? vertex_normal : vec3(0, 0, 1));
    }

    const MaterialConstants& material = materials[mesh.material];
    rtcSetGeometryMask(geometry, material.blend ? kBlendedMask : kSolidMask);
    has_blended_ = has_blended_ || material.blend;
    const RTCFilterFunctionN filter = material.mask ? pass_cut_outs : nullptr;
    rtcSetGeometryIntersectFilterFunction(geometry, filter);
    rtcSetGeometryOccludedFilterFunction(geometry, filter);
}

void TraceScene::pass_cut_outs(const RTCFilterFunctionNArguments* arguments) {
    const auto& data = *static_cast<const FilterData*>(arguments->geometryUserPtr);
    const std::uint32_t primitive = RTCHitN_primID(arguments->hit, arguments->N, 0);
    const vec2 barycentric(RTCHitN_u(arguments->hit, arguments->N, 0),
                           RTCHitN_v(arguments->hit, arguments->N, 0));
    if (data.materials->cut_out(data.scene->instances_[data.instance], primitive, barycentric)) {
        *arguments->valid = 0;
    }
}

void TraceScene::pass_backs(const RTCFilterFunctionNArguments* arguments) {
    const auto& data = *static_cast<const FilterData*>(arguments->geometryUserPtr);
    const TraceInstance& instance = data.scene->instances_[data.instance];
    const std::uint32_t primitive = RTCHitN_primID(arguments->hit, arguments->N, 0);
    const vec3 direction(RTCRayN_dir_x(arguments->ray, arguments->N, 0),
                         RTCRayN_dir_y(arguments->ray, arguments->N, 0),
                         RTCRayN_dir_z(arguments->ray, arguments->N, 0));
    const bool back =
        !(glm::dot(data.scene->triangles_[instance.first_triangle + primitive].normal, direction) < 0);
    if (back && !(*data.materials)[instance.material].double_sided) {
        *arguments->valid = 0;
    }
}

void TraceScene::prefer_front(const vec3& origin, const vec3& direction, Blended blended,
                              SurfaceHit& hit) const {
    if (hit.front) {
        return;
    }
    const float tolerance =
        triangles_[hit.triangle].offset / std::max(glm::length(direction), 1e-30f) + 1e-6f * hit.t;
    SurfaceHit other;
    if (intersect(origin, direction, std::max(hit.t - tolerance, 0.0f), hit.t + tolerance, blended, other,
                  Sides::seen)) {
        hit = other;
    }
}

RTCRayHit TraceScene::query(const vec3& origin, const vec3& direction, float nearest, float farthest,
                            Blended blended) {
    RTCRayHit result;
    result.ray = {origin.x,    origin.y,
                  origin.z,    nearest,
                  direction.x, direction.y,
                  direction.z, 0,
                  farthest,    static_cast<unsigned>(blended),
                  0,           0};
    result.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    return result;
}

void TraceScene::intersect_all(std::span<RTCRayHit> queries) const {
    if (log_ != nullptr) {
        for (const RTCRayHit& query : queries) {
            log_->rays.push_back({query.ray, false});
        }
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (RTCRayHit& query : queries) {
        rtcIntersect1(scene_, &context, &query);
    }
}

bool TraceScene::found(const RTCRayHit& query, SurfaceHit& hit) const {
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return false;
    }
    const vec3 origin(query.ray.org_x, query.ray.org_y, query.ray.org_z);
    const vec3 direction(query.ray.dir_x, query.ray.dir_y, query.ray.dir_z);
    hit.t = query.ray.tfar;
    hit.instance = query.hit.geomID;
    hit.primitive = query.hit.primID;
    hit.triangle = instances_[hit.instance].first_triangle + hit.primitive;
    hit.barycentric = {query.hit.u, query.hit.v};
    const TraceTriangle& triangle = triangles_[hit.triangle];
    hit.front = glm::dot(triangle.normal, direction) < 0;
    hit.normal = hit.front ? triangle.normal : -triangle.normal;
    // The ray's own rounding, most of it along the ray, is taken out again.
    const vec3 p = origin + direction * hit.t;
    hit.position = p - triangle.normal * (glm::dot(triangle.normal, p) - triangle.plane);
    return true;
}

bool TraceScene::intersect(const vec3& origin, const vec3& direction, float nearest, float farthest,
                           Blended blended, SurfaceHit& hit, Sides sides) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (sides == Sides::seen) {
        context.filter = pass_backs;
    }
    RTCRayHit ray = query(origin, direction, nearest, farthest, blended);
    if (log_ != nullptr) {
        log_->rays.push_back({ray.ray, false});
    }
    rtcIntersect1(scene_, &context, &ray);
    return found(ray, hit);
}

RTCRay TraceScene::shadow_ray(const vec3& from, const vec3& span, bool to_infinity, Blended blended) {
    return {from.x,
            from.y,
            from.z,
            0,
            span.x,
            span.y,
            span.z,
            0,
            to_infinity ? std::numeric_limits<float>::infinity() : kShadowEnd,
            static_cast<unsigned>(blended),
            0,
            0};
}

void TraceScene::occlude_all(std::span<RTCRay> rays) const {
    if (log_ != nullptr) {
        for (const RTCRay& ray : rays) {
            log_->rays.push_back({ray, true});
        }
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (RTCRay& ray : rays) {
        rtcOccluded1(scene_, &context, &ray);
    }
}

bool TraceScene::occluded(const vec3& from, const vec3& span, bool to_infinity, Blended blended) const {
    RTCRay ray = shadow_ray(from, span, to_infinity, blended);
    occlude_all(std::span(&ray, 1));
    return is_occluded(ray);
}

}  // namespace lanthorn::reference
