// What photons must not hang on: other lights, surfaces that take no part, values that are no numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "gi_module/techniques/emc/emc_technique.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

FrameScene room_with(std::vector<Mesh> more, std::vector<Material> materials,
                     std::vector<LightInstance> lights) {
    std::vector<Mesh> meshes{box(vec3(0), vec3(4, 2.6f, 4), true, 0)};
    meshes.insert(meshes.end(), more.begin(), more.end());
    return scene_of(std::move(meshes), std::move(materials), std::move(lights), vec3(3.6f, 1.6f, 3.6f),
                    vec3(1, 0.8f, 1));
}

const PhotonTracing& photons_of(Bench& bench) {
    return static_cast<const EmcTechnique&>(bench.technique()).photons();
}

// The arrivals of the photons of one light, which are those from `first` on: where, bounce by bounce.
std::vector<vec3> places(Bench& bench, std::size_t first, std::size_t count) {
    const PhotonTracing& photons = photons_of(bench);
    const auto all = photons.arrived().read();
    const auto n = static_cast<std::size_t>(bench.settings.photons);
    std::vector<vec3> found;
    for (std::size_t bounce = 0; bounce * n < all.size(); ++bounce) {
        for (std::size_t i = first; i < first + count; ++i) {
            found.push_back(all[bounce * n + i].position);
        }
    }
    return found;
}

TEST(Photons, DimmingOneLampLeavesThePathsOfTheOther) {
    const auto scene = [](float first_lamp) {
        return room_with({box(vec3(1, 0, 1), vec3(1.8f, 1.2f, 1.6f), false, 0)}, {lambertian(vec3(0.6f))},
                         {point_light(vec3(1, 2, 3), first_lamp), point_light(vec3(3, 2, 1), 100)});
    };
    Bench bright;
    bright.settings.photons = 4000;
    bright.frame(scene(300), ivec2(32));
    Bench dimmed;
    dimmed.settings.photons = 4000;
    dimmed.frame(scene(100), ivec2(32));
    // The second lamp has a quarter of the photons, then half: the first quarter of them fly as before.
    const std::vector<vec3> before = places(bright, 3000, 1000);
    const std::vector<vec3> after = places(dimmed, 2000, 1000);
    ASSERT_EQ(before.size(), after.size());
    EXPECT_EQ(std::memcmp(before.data(), after.data(), before.size() * sizeof(vec3)), 0);
}

TEST(Photons, TwoLampsHaveNumbersOfTheirOwn) {
    const LightInstance lamp = point_light(vec3(2, 1.3f, 2), 100);
    const FrameScene scene = room_with({}, {lambertian(vec3(0.6f))}, {lamp, lamp});
    Bench bench;
    bench.settings.photons = 2000;
    bench.frame(scene, ivec2(32));
    const std::vector<vec3> one = places(bench, 0, 1000);
    const std::vector<vec3> other = places(bench, 1000, 1000);
    EXPECT_NE(std::memcmp(one.data(), other.data(), one.size() * sizeof(vec3)), 0);
}

// A pane of no alpha is not there, however it glows.
TEST(Photons, PassWhatIsBlendedAndClear) {
    Material glass = lambertian(vec3(0.9f));
    glass.alpha_mode = AlphaMode::blend;
    glass.base_colour.w = 0;
    glass.emissive = vec3(50);
    const std::vector<LightInstance> lights{point_light(vec3(2, 2.2f, 2), 200)};
    const FrameScene with = room_with({box(vec3(0.5f, 0.2f, 1.9f), vec3(3.5f, 2.4f, 1.95f), false, 1)},
                                      {lambertian(vec3(0.6f)), glass}, lights);
    const FrameScene without = room_with({}, {lambertian(vec3(0.6f)), glass}, lights);
    Bench a;
    const ImageF blended = a.frame(with, ivec2(48));
    Bench b;
    const ImageF empty = b.frame(without, ivec2(48));
    EXPECT_EQ(blended.pixels, empty.pixels);
}

TEST(Photons, ValuesThatAreNoNumbersAreReplacedAndCounted) {
    FrameScene scene = room_with({}, {lambertian(vec3(0.6f))}, {point_light(vec3(2, 2, 2), 200)});
    Bench sound;
    sound.frame(scene, ivec2(32));
    EXPECT_EQ(sound.technique().statistics(false).nan_count, 0u);

    // Two lamps: one whose photons carry more than fp32 holds.
    scene = room_with(
        {}, {lambertian(vec3(0.6f))},
        {point_light(vec3(2, 2, 2), 200), point_light(vec3(1, 2, 2), std::numeric_limits<float>::max())});
    scene.lights[1].light.colour = vec3(10);
    Bench broken;
    const ImageF image = broken.frame(scene, ivec2(32));
    EXPECT_GT(broken.technique().statistics(false).nan_count, 0u);
    for (const float value : image.pixels) {
        ASSERT_TRUE(std::isfinite(value));
    }
}

}  // namespace
}  // namespace lanthorn::gi::test
