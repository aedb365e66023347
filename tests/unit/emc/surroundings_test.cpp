// What lies about a camera and its lamps, of worlds that are larger.
#include "gi_module/techniques/emc/maps/surroundings.h"

#include <gtest/gtest.h>

namespace lanthorn::gi {
namespace {

// What an eye sees of a closed cube about the origin, by `n` x `n` squares a face.
Sight of_cube(const vec3& eye, float half, int n = 16) {
    Sight sight;
    for (int i = 0; i < 6 * n * n; ++i) {
        const int axis = i % 3;
        vec3 p(0);
        p[axis] = i / 3 % 2 == 0 ? half : -half;
        p[(axis + 1) % 3] = half * (2 * (static_cast<float>(i / 6 % n) + 0.5f) / static_cast<float>(n) - 1);
        p[(axis + 2) % 3] = half * (2 * (static_cast<float>(i / 6 / n) + 0.5f) / static_cast<float>(n) - 1);
        const vec3 to = p - eye;
        const float d = glm::length(to);
        sight.push_back({to / d, d, std::abs(to[axis]) / (d * d * d)});
    }
    return sight;
}

Aabb cube(float half) {
    return {vec3(-half), vec3(half)};
}

TEST(Surroundings, OfARoomInAWorldAreTheRoom) {
    const FrameScene scene;
    const std::vector<vec3> eyes = {vec3(0.3f, 0, -0.5f)};
    const std::vector<Sight> sights = {of_cube(eyes[0], 1)};
    for (const float world : {100.0f, 1e6f}) {
        const Aabb box = surroundings(scene, eyes, sights, cube(world));
        ASSERT_FALSE(box.empty()) << world;
        EXPECT_NEAR(box.diagonal(), cube(1).diagonal(), 1e-4f);
    }
}

TEST(Surroundings, AreNoneWhereTheRoomIsAllThereIs) {
    const std::vector<vec3> eyes = {vec3(0)};
    const std::vector<Sight> sights = {of_cube(eyes[0], 1)};
    EXPECT_TRUE(surroundings({}, eyes, sights, cube(1)).empty());
    EXPECT_TRUE(surroundings({}, eyes, sights, cube(2)).empty());
}

TEST(Surroundings, AreNoneWhereNothingIsSeen) {
    const std::vector<vec3> eyes = {vec3(0)};
    EXPECT_TRUE(surroundings({}, eyes, std::vector<Sight>(1), cube(100)).empty());
}

TEST(Surroundings, DoNotDependOnTheUnit) {
    for (const float unit : {1e-4f, 1e4f}) {
        const std::vector<vec3> eyes = {unit * vec3(0.3f, 0, -0.5f)};
        const std::vector<Sight> sights = {of_cube(eyes[0], unit)};
        EXPECT_NEAR(surroundings({}, eyes, sights, cube(100 * unit)).diagonal() / unit, cube(1).diagonal(),
                    1e-3f);
    }
}

TEST(Surroundings, AreLookedAtFromTheCameraAndWhatLightsIt) {
    FrameScene scene;
    scene.camera.position = vec3(1, 2, 3);
    const auto lamp = [&](const vec3& position, float intensity) {
        LightInstance light;
        light.light.intensity = intensity;
        light.position = position;
        scene.lights.push_back(light);
    };
    lamp(vec3(1, 2, 1000), 100);
    lamp(vec3(1, 2, 5), 100);
    lamp(vec3(1, 2, 4), 0);
    const std::vector<vec3> eyes = eyes_of_surroundings(scene);
    ASSERT_EQ(eyes.size(), 2u);
    EXPECT_EQ(eyes[0], vec3(1, 2, 3));
    EXPECT_EQ(eyes[1], vec3(1, 2, 5));
    scene.lights.assign(100, scene.lights[1]);
    EXPECT_EQ(eyes_of_surroundings(scene).size(), 8u);
}

}  // namespace
}  // namespace lanthorn::gi
