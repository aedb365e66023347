// Closed shapes as triangles: computed in double precision and rounded once, so that every machine gets the
// same bytes. All faces are counter-clockwise seen from outside, normals are unit length, UVs are in metres
// on flat faces.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::scene_generator {

struct Shape {
    struct Corner {
        dvec3 position{0};
        dvec3 normal{0};
        glm::dvec2 uv{0};
    };
    std::vector<Corner> corners;
    std::vector<std::uint32_t> indices;  // 3 per triangle
};

// The quadrilateral a b c d (in ring order), its front turned towards `towards`. One that is not planar
// becomes two triangles with their own flat normals.
void add_quad(Shape& shape, const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d,
              const dvec3& towards);

// Axis-aligned box between two corners; 12 triangles.
void add_box(Shape& shape, const dvec3& lower, const dvec3& upper);
Shape box(const dvec3& lower, const dvec3& upper);

// A prism over a convex quadrilateral in the plane y = 0 (ring order), from y = 0 up to `height` metres.
Shape prism(const dvec3 (&base)[4], double height);

// Closed cylinder on y = 0 with `sides` smooth sides; radius and height in metres.
Shape cylinder(double radius, double height, int sides);

// Icosahedron whose triangles are divided `levels` times into four, corners on the sphere of `radius` metres:
// 20 * 4^levels triangles, smooth normals. `inward` turns faces and normals to the centre.
Shape icosphere(double radius, int levels, bool inward = false);

// A box of half sides `half` about the origin whose edges are rounded by `radius`: an icosphere pulled apart,
// 20 * 4^levels triangles.
Shape rounded_box(const dvec3& half, double radius, int levels);

}  // namespace lanthorn::scene_generator
