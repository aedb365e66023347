// A body's shape for Bullet, from its description and what the entity looks like.
#pragma once

#include <btBulletCollisionCommon.h>

#include <memory>
#include <string>
#include <vector>

#include "lanthorn/physics/components.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::physics {

// What a triangle mesh shape reads as long as it lives.
struct TriangleData {
    std::vector<double> positions;
    std::vector<int> indices;
    std::unique_ptr<btTriangleIndexVertexArray> array;
};

// What stops a fast body (continuous_world.h).
struct Core {
    btVector3 middle{0, 0, 0};  // a point inside the shape, metres from its origin
    double half_thickness = 0;  // metres from there to the nearest face, of flat ones a little
    double reach = 0;  // metres from the origin to the farthest point; 0: a ball, which turns in its place
};

struct Shape {
    std::unique_ptr<TriangleData> triangles;  // of `mesh` alone; outlives `shape`
    std::unique_ptr<btCollisionShape> shape;  // about `centre`
    Core core;                                // of convex ones
    dvec3 centre{0};  // of mass, metres from the entity's origin, rotation not applied
};

// A shape stretched by `stretch`. `meshes` are the entity's own, needed where the description gives no size;
// flat ones get a thousandth of their diagonal. Null `shape` and a `problem` if there is nothing to make it
// of: no finite vertices, no triangle with an area. O(vertices); `convex` O(n log n).
Shape make_shape(const Collider& collider, const std::vector<const Mesh*>& meshes, const glm::dmat3& stretch,
                 std::string& problem);

}  // namespace lanthorn::physics
