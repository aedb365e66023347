// After Frisvad et al. 2005, Fig. 7: the Cornell box, in it a lamp and an orange ball so close to it that few
// parts of what the lamp sees show anything else on that side.
#include <algorithm>

#include "tools/scene_generator/builder.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace {

constexpr double kBall = 0.03, kApart = 0.05;  // metres: radius, and its middle from the lamp

}  // namespace

SceneData near_lamp() {
    Builder b;
    b.scene = cornell();
    std::ranges::find(b.scene.materials, "lamp", &Material::name)->emissive = vec3(0);
    const dvec3 lamp_at(-0.278, 0.36, -0.2);
    Light lamp;
    lamp.intensity = 8;
    b.light("near-lamp", at(lamp_at), lamp);
    b.solid("near-ball", icosphere(kBall, 2), b.matte("orange", {0.8f, 0.35f, 0.08f}, 0), {},
            at(lamp_at + kApart * glm::normalize(dvec3(0.5, -0.6, -0.6))));
    return b.scene;
}

}  // namespace lanthorn::scene_generator
