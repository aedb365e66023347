// A scene as plain data, and the way it takes into a FrameScene: spawned below one node, extracted like any
// other.
#pragma once

#include <vector>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::extremes {

// In metres, at ordinary size and place.
struct Stage {
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<LightInstance> lights;
    Sky sky;  // without an image: none
    Camera camera;
    vec3 eye{0};
    vec3 target{0, 0, -1};
};

// Of any channel of its materials' base colours.
float largest_albedo(const Stage& stage);

// Where the node above everything stands.
struct Placement {
    double scale = 1;
    dvec3 offset{0};  // metres, in the world
    dvec3 walk{0};    // metres it all moves after a first extraction, which has chosen the origin
};

// Intensities in candela grow by the square of the scale, so that every surface is lit as at scale 1.
FrameScene frame_of(const Stage& stage, const Placement& placement);

}  // namespace lanthorn::extremes
