// What the tests of mirrors and glass share: a room, a pane, and pictures by exact rays and by those of the
// maps.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {

constexpr ivec2 kSize(96);
constexpr float kNits = 100;

Material glass(float ior, float thickness);

// A room whose walls have three colours, with a block; `more`: stands in it too. `wall`: the one at x = 4 is
// there.
FrameScene room(std::vector<Mesh> more, std::vector<Material> materials, const vec3& eye, const vec3& target,
                bool wall = true);

class Specular : public ::testing::TestWithParam<EmcRays> {
  protected:
    static void SetUpTestSuite();
    GiSettings settings() const;
    // Radiance of a still picture, nits. What is mirrored has been reflected once less than what is seen.
    ImageF picture(FrameScene scene, int bounces = 2, int grid = 1) const;
};

// A pane right before the eye, that reflects nothing.
struct Pane {
    explicit Pane(const vec3& eye, const vec3& target) {
        const vec3 towards = glm::normalize(eye - target);
        right = glm::normalize(glm::cross(vec3(0, 1, 0), towards));
        up = glm::cross(towards, right);
        corner = eye - 0.4f * towards - 0.5f * (right + up);
    }
    static Material material(const vec3& colour) {
        Material m = glass(1.5f, 0);
        m.specular = 0;
        m.base_colour = vec4(colour, 1);
        return m;
    }
    vec3 right, up, corner;
};
constexpr vec3 kPaneEye(3.4f, 1.3f, 2.6f), kPaneTarget(0.8f, 0.9f, 0.6f);

// Mean over the middle half of the picture, by channel.
vec3 middle_of(const ImageF& image);

}  // namespace lanthorn::gi::test
