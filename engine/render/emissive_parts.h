// Emissive surfaces in parts, and what stands for some of them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/render/emissive.h"

namespace lanthorn::render {

// The triangles of some surfaces, in two places: where they are, and where their meshes at rest have them.
// Parts are cut and grouped by the latter alone, so that rounding never groups a lamp that moves in another
// way.
struct EmissiveShape {
    std::span<const EmissiveTriangleData> shown;
    std::span<const EmissiveTriangles::Rest> rest;
};

// A triangle of what a sample stands for: where it is, and where it lies and faces as its mesh has it at
// rest, whatever the size of that.
struct EmissiveFace {
    vec3 p[3];         // counter-clockwise seen from the front
    vec3 radiance{0};  // nits
    vec3 at{0}, normal{0};
};

// What stands for some parts: a point of them with nothing of them before it, and the way they face together.
struct EmissiveSample {
    vec3 point{0}, normal{0};
    float area = 0;    // m^2
    vec3 radiance{0};  // nits, the mean over the area
    std::vector<EmissiveFace> faces;
    bool connected = false;  // known to be of one piece of the surface
};

// How many points it takes to stand for a surface, where `flat` do for a flat one without holes: half as many
// for each of the six ways that a twentieth of its light leaves, and one for each piece of it that stands
// apart, at most `most`. O(triangles).
int samples_wanted(const EmissiveShape& shape, int flat, int most);

// `count` samples at most, each for parts that lie together and face the same way: a closed surface (a bulb)
// shines to all sides. The same for the same triangles, and for a surface that moves as a whole. Cost: 16
// times triangles times count, at most some 20 ms.
std::vector<EmissiveSample> emissive_samples(const EmissiveShape& shape, int count);

}  // namespace lanthorn::render
