// What the tests of caustic photons share: a floor for closed forms, a room, and the light that photons
// bring.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/emc/emc_statistics.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {

constexpr ivec2 kSize(96);

// Light on a floor y = 0 of 2 m x 2 m about the origin, seen straight from above, by caustics alone: what the
// picture holds more than without them.
struct Floor {
    static constexpr float kHalf = 1;
    std::vector<Mesh> meshes{quad(vec3(-kHalf, 0, -kHalf), vec3(0, 0, 2 * kHalf), vec3(2 * kHalf, 0, 0), 0)};
    // Dark: what it sends back into mirrors and glass is no part of the closed forms.
    std::vector<Material> materials{lambertian(vec3(0.02f))};
    std::vector<LightInstance> lights;

    FrameScene scene() const {
        FrameScene scene = scene_of(meshes, materials, lights, vec3(0, 1.5f, 0), vec3(0));
        look_closely(scene, vec3(0, 0.5f, 0), vec3(0), kHalf);
        return scene;
    }
};

// `photons`: caustic ones. By exact rays the maps are small: for what else a picture shows ask for
// with_usual_maps().
GiSettings settings_of(int photons, EmcFinal final_stage = EmcFinal::gather, EmcRays rays = EmcRays::bvh);

GiSettings with_usual_maps(GiSettings settings);

Material glass(float ior);

class Caustics : public testing::Test {
  protected:
    void SetUp() override;  // rays that are exact can be asked for

    static ImageF caustics_of(const FrameScene& scene, int photons, EmcFinal final_stage = EmcFinal::gather,
                              EmcRays rays = EmcRays::bvh);

    // Where a place in a pixel lies on the floor.
    static vec3 place(int x, int y, vec2 in_pixel = vec2(0.5f));
};

// Closed, a cube of 4 m of one grey.
FrameScene room_with(std::vector<Mesh> things, std::vector<Material> materials,
                     std::vector<LightInstance> lights);

// Green light that is stored of all that mirrors and glass send on, lumens. What is aimed at a ball and met
// is the light's flux in the ball's solid angle; none is lost on the way.
double stored_flux(const FrameScene& scene, const GiSettings& settings, CausticStatistics* all = nullptr);

}  // namespace lanthorn::gi::test
