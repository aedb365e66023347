// What a glTF node's `extras` say of physics. Angles in radians, all else in SI units; every field may be
// left out.
//
//   {"body": {"type": "static" | "dynamic" | "kinematic",                       static
//             "shape": "box" | "sphere" | "capsule" | "convex" | "mesh",        box
//             "mass": kilograms, dynamic bodies only, > 0,                      1
//             "friction": >= 0,                                                 0.5
//             "restitution": 0..1,                                              0
//             "size": [x, y, z] metres, all > 0, of a box,                      the meshes' bounds
//             "radius": metres > 0, of a sphere or capsule,                     the meshes' bounds
//             "height": metres > 0, of a capsule along Y, its caps included,    the meshes' bounds
//             "centre": [x, y, z] metres}}                                      the bounds' centre; 0 with a
//             size
//   {"character": {"radius": > 0,                                               0.3
//                  "height": >= 2 radii,                                        1.8
//                  "stepHeight": >= 0,                                          0.35
//                  "slopeLimit": 0..pi/2,                                       0.87
//                  "jumpSpeed": m/s >= 0}}                                      4.5
//
// Sizes are in the node's own space: its scale in the world multiplies them, but not a character's.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::physics {

enum class BodyType { fixed, dynamic, kinematic };
enum class BodyShape { box, sphere, capsule, convex, mesh };

struct BodyDescription {
    BodyType type = BodyType::fixed;
    BodyShape shape = BodyShape::box;
    double mass = 1;  // kilograms
    double friction = 0.5;
    double restitution = 0;
    std::optional<dvec3> size;  // metres, whole edges
    std::optional<double> radius;
    std::optional<double> height;
    std::optional<dvec3> centre;
};

struct CharacterDescription {
    double radius = 0.3;        // metres
    double height = 1.8;        // metres, from the feet to the top
    double step_height = 0.35;  // metres that a foot lifts
    double slope_limit = 0.87;  // radians from the level that can still be walked on
    double jump_speed = 4.5;    // m/s at take-off
};

struct PhysicsExtras {
    std::optional<BodyDescription> body;
    std::optional<CharacterDescription> character;
    std::vector<std::string> problems;  // what was found and what was expected; of a skipped one too
};

// Never throws: a body or character with a wrong value is left out and the value is named in `problems`. A
// key that is not known is named and ignored.
PhysicsExtras read_extras(std::string_view json);

}  // namespace lanthorn::physics
