#include "tools/scene_generator/builder.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

// Radius r = 1 m, albedo a = 0.5, I = 100 cd at the centre: direct irradiance is I / r^2 everywhere, and
// since every point of a sphere sees every other with the same form factor, n reflections add I / r^2 * (a +
// ... + a^n).
SceneData furnace_sphere() {
    Builder b;
    b.solid("sphere", icosphere(1.0, 4, true), b.matte("half", vec3(0.5f), 0));
    Light lamp;
    lamp.type = LightType::point;
    lamp.intensity = 100;
    b.light("lamp", at({0, 0, 0}), lamp);
    b.camera("camera", looking({0, 0, 0.5}, {0, 0, -1}), glm::radians(70.0f), 0.01f);
    return b.scene;
}

}  // namespace lanthorn::scene_generator
