// The FrameScene as rays meet it: Embree's acceleration structure and, beside it, what shading needs of each
// triangle.
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "gi_module/reference/reduced_shape.h"
#include "lanthorn/core/range_allocator.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::reference {

inline constexpr std::uint32_t kNoEmitter = 0xffffffffu;

// One triangle, ready for shading. Render space.
struct TraceTriangle {
    vec3 normal{0};                      // unit, out of the front
    float plane = 0;                     // dot(normal, p) of its points
    float offset = 0;                    // metres a ray must start off its plane so as not to meet it again
    std::uint32_t emitter = kNoEmitter;  // into Emitters; set by them
};

// One instance, in FrameScene's order.
struct TraceInstance {
    std::uint32_t id = 0;  // Instance::id
    const Mesh* mesh = nullptr;
    std::uint32_t material = 0;
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_places = 0;  // from there on, at least as many as it has triangles
    mat3 to_render{1};                  // vectors
    std::vector<vec3> normals;          // by vertex, render space, unit or 0
    float mirror = 1;                   // -1 where the transform mirrors
    bool coloured = false;              // some vertex colour is not white
};

// Where a ray met a surface.
struct SurfaceHit {
    float t = 0;       // in lengths of the ray's direction
    vec3 position{0};  // on the triangle's plane
    vec3 normal{0};    // the triangle's own, unit, on the side that the ray came from
    bool front = false;
    std::uint32_t instance = 0;
    std::uint32_t primitive = 0;
    std::uint32_t triangle = 0;  // into triangles()
    vec2 barycentric{0};         // weights of the second and third vertex
};

// Which blended surfaces a ray meets: none, all, by chance with their alpha, or where a camera sees them
// solid (alpha_coverage.h). Masked ones are met where they are not cut out, always.
enum class Blended : std::uint32_t {
    ignored = 1,
    met = 2 | 1,
    by_chance = 4 | 1,
    solid = 8 | 1
};  // Embree's ray masks

// Which sides: the backs of single-sided surfaces may be passed over.
enum class Sides { both, seen };

// What the acceleration structure is built for: the fastest rays, or frames in which things move.
enum class Structure { still, moving };

class MaterialTable;
struct RayLog;

class TraceScene {
  public:
    // Builds everything; `scene` must outlive this, or what follow() is given in its place. A reduced shape
    // is not met by rays that start within twice its error of where they would. Throws InputError if Embree
    // cannot (out of memory). O(triangles log triangles), on one thread so that the structure is the same in
    // every run.
    TraceScene(const FrameScene& scene, const MaterialTable& materials,
               Structure structure = Structure::still, const ReducedShapes& reduced = {});
    ~TraceScene();
    TraceScene(const TraceScene&) = delete;
    TraceScene& operator=(const TraceScene&) = delete;

    // Takes the instances of the next frame's scene, before follow(): those that are gone leave the
    // structure, those that have come get a part of their own from follow(). The others keep theirs, whatever
    // their numbers. Only for Structure::moving. False, and nothing is changed, if all are others or the
    // origin moved: build it whole. O(instances).
    bool admit(const FrameScene& scene);

    // Becomes the next frame's scene, by what its `changes` say: an instance that moved or deformed has its
    // own part of the structure refitted, one with other triangles has it built anew, the others are left
    // alone. Only for Structure::moving, and with the table that it was made with (which may have been
    // assigned anew). False, and nothing is changed, if instances came or went that were not admitted, or the
    // origin moved: build it whole. O(instances + vertices that moved); what moved is placed on several
    // threads.
    bool follow(const FrameScene& scene, const MaterialTable& materials, const ReducedShapes& reduced = {});

    // The nearest surface with nearest < t < farthest.
    bool intersect(const vec3& origin, const vec3& direction, float nearest, float farthest, Blended blended,
                   SurfaceHit& hit, Sides sides = Sides::both) const;
    // The same for many rays at once. intersect_all() wants queries as query() makes them; found() then reads
    // one as intersect() would have. In three steps, as rays that do not wait for each other's surfaces are
    // faster.
    static RTCRayHit query(const vec3& origin, const vec3& direction, float nearest, float farthest,
                           Blended blended);
    void intersect_all(std::span<RTCRayHit> queries) const;
    bool found(const RTCRayHit& query, SurfaceHit& hit) const;
    // If `hit` is the back of a single-sided surface and another's front lies in the same place (a sheet made
    // of two), that front.
    void prefer_front(const vec3& origin, const vec3& direction, Blended blended, SurfaceHit& hit) const;
    // Whether anything lies between `from` and `from + span`; `span` need not be unit, infinite reach if
    // `to_infinity`.
    bool occluded(const vec3& from, const vec3& span, bool to_infinity, Blended blended) const;
    // The same for many; is_occluded() of each ray then tells.
    static RTCRay shadow_ray(const vec3& from, const vec3& span, bool to_infinity, Blended blended);
    void occlude_all(std::span<RTCRay> rays) const;
    static bool is_occluded(const RTCRay& ray) { return ray.tfar < 0; }

    const std::vector<TraceInstance>& instances() const { return instances_; }
    // Of what a query met, into instances().
    std::uint32_t instance_of(const RTCRayHit& met) const { return instance_of_[met.hit.geomID]; }
    const std::vector<TraceTriangle>& triangles() const { return triangles_; }
    std::vector<TraceTriangle>& triangles() { return triangles_; }
    // Of one of the instance's own triangles (or of its reduced shape's), where it stands. Render space.
    std::array<vec3, 3> corners(std::uint32_t instance, std::uint32_t primitive) const {
        const std::uint32_t* v = &instances_[instance].mesh->indices[3 * std::size_t{primitive}];
        const float* p = shapes_[instance].positions;
        const auto at = [&](std::size_t k) {
            return vec3(p[3 * std::size_t{v[k]}], p[3 * std::size_t{v[k]} + 1], p[3 * std::size_t{v[k]} + 2]);
        };
        return {at(0), at(1), at(2)};
    }
    // Whether its triangles are its mesh's own.
    bool whole(std::uint32_t instance) const { return shapes_[instance].posed == nullptr; }
    const FrameScene& frame() const { return *frame_; }
    bool has_blended() const { return has_blended_; }

    // Notes every ray from here on; null: no more. While it notes, from one thread alone.
    void log_to(RayLog* log);

  private:
    struct FilterData;  // what Embree's filters need of an instance
    static constexpr std::uint32_t kNoGeometry = 0xffffffffu;
    // Whose triangles an instance has, and where they stand.
    struct Shape {
        std::uint32_t geometry = kNoGeometry;  // Embree's number; it has none before it is built
        std::uint64_t mesh_version = 0;
        std::uint64_t refined = 0;  // RefinedTopology::serial, or 0
        bool deformed = false;
        std::uint32_t moves = 0;  // since it was built
        std::shared_ptr<const ReducedShape> reduced;
        std::unique_ptr<Mesh> posed;  // null: the asset's own mesh
        std::unique_ptr<FilterData> filter;
        const float* positions = nullptr;  // Embree's, three a vertex
    };
    static bool has_shape(const Shape& shape, const FrameScene& scene, const Instance& instance,
                          const ReducedShape* reduced);
    // Makes the instance's part of the structure, in place of one that is there.
    void build(std::size_t index, const MaterialTable& materials,
               std::shared_ptr<const ReducedShape> reduced);
    // Writes what hangs on an instance's pose and material: vertices, normals, planes, mask and filters.
    void place(std::size_t index, const MaterialTable& materials, RTCGeometry geometry);
    void find_blended(const MaterialTable& materials);
    void commit();
    void remove(const Shape& shape, const TraceInstance& instance);
    // A place in triangles() for so many.
    std::uint32_t place_for(std::uint32_t count);
    static void pass_left_out(const RTCFilterFunctionNArguments* arguments);
    static void pass_backs(const RTCFilterFunctionNArguments* arguments);

    const FrameScene* frame_;
    dvec3 origin_;  // of the frame that the structure was made for
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    std::vector<Shape> shapes_;  // by instance
    std::vector<TraceInstance> instances_;
    std::vector<TraceTriangle> triangles_;
    std::vector<std::uint32_t> instance_of_;  // by Embree's number
    std::vector<std::uint32_t> unused_;       // of those numbers
    RangeAllocator places_;                   // in triangles_
    bool admitted_ = false;                   // instances have come or gone since the last follow()
    bool has_blended_ = false;
    RayLog* log_ = nullptr;
};

// Written where it will lie: a copy of what was just written field by field is slow.
inline RTCRayHit TraceScene::query(const vec3& origin, const vec3& direction, float nearest, float farthest,
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

inline bool TraceScene::found(const RTCRayHit& query, SurfaceHit& hit) const {
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return false;
    }
    const vec3 origin(query.ray.org_x, query.ray.org_y, query.ray.org_z);
    const vec3 direction(query.ray.dir_x, query.ray.dir_y, query.ray.dir_z);
    hit.t = query.ray.tfar;
    hit.instance = instance_of(query);
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

// The point on the side of `normal` that a ray may start from without meeting the triangle it leaves (after
// Waechter and Binder 2019, "A Fast and Robust Method for Avoiding Self-Intersection": an offset along the
// triangle's normal that grows with the coordinates' own rounding; here by the triangle's largest one).
inline vec3 off_surface(const SurfaceHit& hit, const vec3& normal, const TraceTriangle& triangle) {
    return hit.position + normal * triangle.offset;
}

}  // namespace lanthorn::reference
