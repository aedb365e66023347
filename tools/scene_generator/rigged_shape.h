// Closed shapes whose points are bound to joints. Double precision, rounded once.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "lanthorn/scene/mesh.h"

namespace lanthorn::scene_generator {

// Joints from the top down, each with the height at which it takes over from the one above, metres.
struct JointChain {
    std::vector<std::pair<std::uint16_t, double>> joints;
    double soft = 0.06;  // half the height over which two joints share

    // Weights of a point at height `y`.
    SkinInfluences at(double y) const;
};

// An ellipse in a plane of constant y.
struct Ring {
    dvec3 centre{0};
    double x = 0, z = 0;  // half axes; both 0: a single point, the first or last ring
};

struct RiggedShape {
    std::vector<dvec3> positions;
    std::vector<SkinInfluences> influences;  // one a position, or empty
    std::vector<std::uint32_t> indices;      // counter-clockwise seen from outside

    // A closed tube round the rings, which go upwards and begin and end with a point; `chain` null: not
    // bound.
    void add_tube(const std::vector<Ring>& rings, int sides, const JointChain* chain);
};

// The rings of an upright capsule whose ends are half-ellipsoids: from `low` to `high` (the poles), with half
// axes `x_low`, `x_high`; z is x times `flat`. `middle` and `cap`: rings
// of the straight part and of each end.
std::vector<Ring> capsule(const dvec3& low, const dvec3& high, double x_low, double x_high, double flat = 1,
                          int middle = 8, int cap = 5);

// Area-weighted unit normals of a closed surface.
std::vector<dvec3> smooth_normals(const std::vector<dvec3>& positions,
                                  const std::vector<std::uint32_t>& indices);

// The shape as a mesh with smooth normals.
Mesh smooth_mesh(const std::string& name, const RiggedShape& shape, std::uint32_t material);

// The same with an edge wherever faces meet at more than 35 degrees.
Mesh edged_mesh(const std::string& name, const RiggedShape& shape, std::uint32_t material);

// Adds a face to the mesh's cage, flat, each corner bound by `hang` at its height; corners counter-clockwise.
void add_hanging_face(Mesh& mesh, const std::array<dvec3, 4>& corners, const JointChain& hang);

// The target that moves the shape's points to `moved`, normals included.
MorphTarget morph_target(const RiggedShape& shape, const std::vector<dvec3>& moved);

}  // namespace lanthorn::scene_generator
