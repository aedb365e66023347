// A room with a block and a lamp that tests move about.
#pragma once

#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {

// Closed, 4 x 2.6 x 3 m; the block, 0.8 x 2 x 1.6 m, stands in the middle of it but for its x.
inline FrameScene room_with_block(float x) {
    FrameScene scene =
        scene_of({box(vec3(0), vec3(4, 2.6f, 3), true, 0),
                  box(vec3(-0.4f, 0, -0.8f), vec3(0.4f, 2.0f, 0.8f), false, 1)},
                 {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))},
                 {point_light(vec3(0.6f, 2.2f, 1.5f), 100)}, vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
    Instance& block = scene.instances[1];
    block.transform[3] = vec4(x, 0, 1.5f, 1);
    block.bounds = transformed(scene.assets->meshes[1].bounds, block.transform);
    return scene;
}

// Marks what that changes, and nothing else.
inline void move_block(FrameScene& scene, float x) {
    const FrameScene there = room_with_block(x);
    hold_still(scene);
    scene.instances = there.instances;
    scene.changes.geometry = true;
    scene.changes.moved = {1};
}

inline void move_lamp(FrameScene& scene, const vec3& to) {
    hold_still(scene);
    scene.lights[0].position = to;
    scene.changes.lights = true;
}

}  // namespace lanthorn::gi::test
