#include "engine/physics/body_shape.h"

#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/physics/bullet_types.h"
#include "engine/physics/placement.h"

namespace lanthorn::physics {

namespace {

constexpr double kFlat = 1e-3;  // least thickness, as a share of the diagonal
// Metres, half a thickness: smaller boxes have all contacts with a triangle at once, which costs more; by one
// contact a step they sink in.
constexpr double kSmallBox = 0.15 * (1 + 1e-6);
constexpr double kHullMargin = 2e-3;  // Bullet's skin around a hull, as a share of its least extent

struct Bounds {
    dvec3 lower{std::numeric_limits<double>::infinity()};
    dvec3 upper{-std::numeric_limits<double>::infinity()};

    void add(const dvec3& p) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    bool empty() const { return !(lower.x <= upper.x); }
    dvec3 centre() const { return 0.5 * (lower + upper); }
    // Nowhere thinner than a share of the diagonal.
    dvec3 half() const {
        const dvec3 size = upper - lower;
        return 0.5 * glm::max(size, dvec3(kFlat * glm::length(size)));
    }
};

// The largest factors along the entity's axes.
dvec3 scale_of(const glm::dmat3& stretch) {
    return {glm::length(stretch[0]), glm::length(stretch[1]), glm::length(stretch[2])};
}

std::vector<dvec3> stretched_vertices(const std::vector<const Mesh*>& meshes, const glm::dmat3& stretch) {
    std::vector<dvec3> points;
    for (const Mesh* mesh : meshes) {
        for (const Vertex& v : mesh->vertices) {
            points.push_back(stretch * dvec3(v.position));
        }
    }
    return points;
}

Bounds bounds_of(const std::vector<dvec3>& points) {
    Bounds bounds;
    for (const dvec3& p : points) {
        if (is_finite(p)) {
            bounds.add(p);
        }
    }
    return bounds;
}

std::unique_ptr<btCollisionShape> box(const dvec3& half) {
    auto shape = std::make_unique<btBoxShape>(bt(half));
    if (std::min({half.x, half.y, half.z}) <= kSmallBox) {
        shape->initializePolyhedralFeatures();  // for its contacts with triangles
    }
    return shape;
}

std::unique_ptr<btCollisionShape> capsule(double radius, double height) {
    return std::make_unique<btCapsuleShape>(radius, std::max(height - 2 * radius, 0.0));
}

// The middle of the vertices and the way from there to the nearest face.
Core core_of(const btConvexHullComputer& hull) {
    Core core;
    for (int i = 0; i < hull.vertices.size(); ++i) {
        core.middle += hull.vertices[i] / hull.vertices.size();
    }
    core.half_thickness = std::numeric_limits<double>::infinity();
    for (int i = 0; i < hull.faces.size(); ++i) {
        const auto* edge = &hull.edges[hull.faces[i]];
        const btVector3& a = hull.vertices[edge->getSourceVertex()];
        const btVector3& b = hull.vertices[edge->getTargetVertex()];
        const btVector3& c = hull.vertices[edge->getNextEdgeOfFace()->getTargetVertex()];
        const btVector3 normal = (b - a).cross(c - a);
        if (normal.length() > 0) {
            core.half_thickness =
                std::min(core.half_thickness, std::abs(normal.dot(core.middle - a)) / normal.length());
        }
    }
    return core;
}

std::unique_ptr<btCollisionShape> hull(const std::vector<dvec3>& points, const Bounds& bounds, Core& core) {
    std::vector<double> relative;
    for (const dvec3& p : points) {
        if (is_finite(p)) {
            const dvec3 q = p - bounds.centre();
            relative.insert(relative.end(), {q.x, q.y, q.z});
        }
    }
    btConvexHullComputer computer;
    computer.compute(relative.data(), 3 * sizeof(double), static_cast<int>(relative.size() / 3), 0, 0);
    auto shape = std::make_unique<btConvexHullShape>();
    for (int i = 0; i < computer.vertices.size(); ++i) {
        shape->addPoint(computer.vertices[i], false);
    }
    shape->recalcLocalAabb();
    const dvec3 half = bounds.half();
    core = core_of(computer);
    // Of a flat one as much as a flat box has.
    core.half_thickness = std::clamp(core.half_thickness, kFlat * glm::length(half), glm::length(half));
    shape->setMargin(2 * kHullMargin * std::min({half.x, half.y, half.z}));
    return shape;
}

// Of a hull the thickness is known.
void complete_core(const btCollisionShape& shape, Core& core) {
    core.reach = shape.getAngularMotionDisc();
    if (shape.getShapeType() == SPHERE_SHAPE_PROXYTYPE) {
        core.half_thickness = core.reach;
        core.reach = 0;
    } else if (shape.getShapeType() == BOX_SHAPE_PROXYTYPE) {
        const btVector3 half = static_cast<const btBoxShape&>(shape).getHalfExtentsWithMargin();
        core.half_thickness = half[half.minAxis()];
    } else if (shape.getShapeType() == CAPSULE_SHAPE_PROXYTYPE) {
        core.half_thickness = static_cast<const btCapsuleShape&>(shape).getRadius();
    }
}

// False where no triangle has an area.
bool make_triangles(const std::vector<const Mesh*>& meshes, const std::vector<dvec3>& points, Shape& result) {
    auto data = std::make_unique<TriangleData>();
    for (const dvec3& p : points) {
        const dvec3 q = is_finite(p) ? p - result.centre : dvec3(0);
        data->positions.insert(data->positions.end(), {q.x, q.y, q.z});
    }
    std::size_t first = 0;
    for (const Mesh* mesh : meshes) {
        for (std::size_t i = 0; i + 2 < mesh->indices.size(); i += 3) {
            const std::size_t v[3] = {first + mesh->indices[i], first + mesh->indices[i + 1],
                                      first + mesh->indices[i + 2]};
            const double area =
                glm::length(glm::cross(points[v[1]] - points[v[0]], points[v[2]] - points[v[0]]));
            if (std::isfinite(area) && area > 0) {
                for (const std::size_t corner : v) {
                    data->indices.push_back(static_cast<int>(corner));
                }
            }
        }
        first += mesh->vertices.size();
    }
    if (data->indices.empty()) {
        return false;
    }
    data->array = std::make_unique<btTriangleIndexVertexArray>(
        static_cast<int>(data->indices.size() / 3), data->indices.data(), static_cast<int>(3 * sizeof(int)),
        static_cast<int>(data->positions.size() / 3), data->positions.data(),
        static_cast<int>(3 * sizeof(double)));
    auto shape = std::make_unique<btBvhTriangleMeshShape>(data->array.get(), true);
    shape->setMargin(0);
    result.shape = std::move(shape);
    result.triangles = std::move(data);
    return true;
}

}  // namespace

Shape make_shape(const Collider& collider, const std::vector<const Mesh*>& meshes, const glm::dmat3& stretch,
                 std::string& problem) {
    Shape result;
    const dvec3 scale = scale_of(stretch);
    const double largest = std::max({scale.x, scale.y, scale.z});
    const bool sized = (collider.shape == BodyShape::box && collider.size) ||
                       (collider.shape == BodyShape::sphere && collider.radius) ||
                       (collider.shape == BodyShape::capsule && collider.radius && collider.height);
    const std::vector<dvec3> points = sized ? std::vector<dvec3>() : stretched_vertices(meshes, stretch);
    const Bounds bounds = bounds_of(points);
    if (!sized && bounds.empty()) {
        problem = "has no vertices to make its body's shape of, expected a mesh or a size: skipped";
        return result;
    }
    const dvec3 half = bounds.empty() ? dvec3(0) : bounds.half();
    if (!sized && !(glm::length(half) > 0)) {
        problem = "has vertices in one point alone, expected a mesh of some size: skipped";
        return result;
    }
    result.centre = collider.centre ? stretch * *collider.centre : sized ? dvec3(0) : bounds.centre();
    switch (collider.shape) {
        case BodyShape::box:
            result.shape = box(collider.size ? 0.5 * *collider.size * scale : half);
            break;
        case BodyShape::sphere:
            result.shape = std::make_unique<btSphereShape>(
                collider.radius ? *collider.radius * largest : std::max({half.x, half.y, half.z}));
            break;
        case BodyShape::capsule:
            result.shape = capsule(
                collider.radius ? *collider.radius * std::max(scale.x, scale.z) : std::max(half.x, half.z),
                collider.height ? *collider.height * scale.y : 2 * half.y);
            break;
        case BodyShape::convex:
            result.centre = bounds.centre();
            result.shape = hull(points, bounds, result.core);
            break;
        case BodyShape::mesh:
            result.centre = bounds.centre();
            if (!make_triangles(meshes, points, result)) {
                problem = "has no triangle with an area, expected one for a shape 'mesh': skipped";
            }
            break;
    }
    if (result.shape && result.shape->isConvex()) {
        complete_core(*result.shape, result.core);
    }
    return result;
}

}  // namespace lanthorn::physics
