// Where caustic photons are sent: the parts of a scene that mirror light or let it through, and how much of a
// light's flux is on its way to each (Yao et al. 2010, sec. 7). Pure functions, no GL.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/scene/diffuse_reflectance.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// Whether photons are aimed at things of this material: a metal that is smooth enough to throw patterns of
// light, or anything that light goes through.
bool throws_caustics(const Material& material);

// Things that photons are aimed at together.
struct CausticTarget {
    Aabb bounds;        // render space
    std::uint64_t key;  // of its photons' random numbers: the first thing's entity, and its place there
};

struct CausticTargets {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::vector<CausticTarget> targets;
    std::vector<std::uint32_t> of_instance;  // by instance: index of its target, or kNone
    double diagonal = 0;                     // of all instances' bounds, metres

    // One target an instance; where there are more than `most`, neighbours share one. O(n log n).
    static CausticTargets of(const FrameScene& scene, std::size_t most);
    // One target that all of the scene is.
    static CausticTargets everything(const FrameScene& scene);
};

// The directions from a point, or the places a parallel beam starts from, in which all of a box lies.
struct CausticAim {
    // Of a point: a cone. Of a parallel beam: none.
    dvec3 axis{0, 0, 1};
    double one_less_cosine =
        0;  // of the cone's half angle: 1 - cos, so that narrow ones are exact; 2: all around
    // Of a parallel beam: a rectangle, its corner and edges.
    dvec3 corner{0}, right{0}, up{0};

    double solid_angle() const { return 2 * 3.14159265358979323846 * one_less_cosine; }
    double area() const { return glm::length(glm::cross(right, up)); }
};

// The narrowest simple cone about a box as seen from a point: about its corners, or about its sphere where
// the point is too near for that; all around from within.
CausticAim aim_at(const Aabb& box, const dvec3& from);
// The rectangle that all of a box lies behind for light that shines along unit `direction`. It stands before
// the box.
CausticAim aim_beam(const Aabb& box, const dvec3& direction);
// A direction in the cone, u in [0, 1)^2, evenly by solid angle.
dvec3 in_cone(const CausticAim& aim, const glm::dvec2& u);

// How much flux a light sends into the aim at `box`, lumen, luminance: exact for points and parallel beams;
// for spots an upper bound, 0 where the cones do not meet. 0 beyond the light's range.
double flux_towards(const LightInstance& light, const Aabb& box);

// Whether there are such things, and any light that reaches them or something that may send it on to them.
// O(instances + lights), no memory.
enum class CausticCause { found, nothing_specular, no_light };
CausticCause caustic_cause(const FrameScene& scene);

}  // namespace lanthorn::gi
