// Eyes in odd places: inside closed things that are culled from within, behind walls that face away, close to
// walls. Indirect light is what `path` finds there, in the first frames as after many.
#include <gtest/gtest.h>

#include <cstdio>
#include <ostream>
#include <string>

#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/gather_scene.h"
#include "tests/gpu/gi/path_truth.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(64);
constexpr int kFrames = 12, kSpp = 128;
constexpr int kBounces = 8;  // of the reference; 0.5^8 of the light is left
constexpr double kFlux = 0.02, kError = 0.06;

// In a room of 8 x 3 x 8 m with a lamp; nothing else, or one thing about the eye.
struct Eye {
    const char* name;
    std::vector<Mesh> things;
    vec3 from{0, 1.5f, 0.2f}, to{0, 1.2f, -3};
    mat4 place{1};  // of the things
};

void PrintTo(const Eye& eye, std::ostream* out) {
    *out << eye.name;
}

std::vector<Eye> eyes() {
    const vec3 middle(0, 1.5f, 0);
    const auto cube = [&](float half) { return box(middle - half, middle + half, false, 1); };
    const mat4 to_middle = glm::translate(mat4(1), middle);
    return {
        {"in_a_box", {cube(0.5f)}},
        {"in_two_boxes", {cube(0.5f), cube(0.8f)}},
        {"in_a_ball",
         {support::sphere(vec3(0), 0.6f, 3, false, 1)},
         vec3(0, 1.5f, 0.2f),
         vec3(0, 1.2f, -3),
         to_middle},
        {"in_a_turned_box",
         {box(vec3(-0.6f), vec3(0.6f), false, 1)},
         vec3(0, 1.5f, 0.2f),
         vec3(0, 1.2f, -3),
         glm::rotate(to_middle, 0.7f, glm::normalize(vec3(1, 2, 0.5f)))},
        // Its fronts face outwards: the transform turns the winding round.
        {"in_a_mirrored_box",
         {box(vec3(-0.5f), vec3(0.5f), false, 1)},
         vec3(0, 1.5f, 0.2f),
         vec3(0, 1.2f, -3),
         glm::scale(to_middle, vec3(-1, 1, 1))},
        {"a_millimetre_off_a_wall", {cube(0.3f)}, vec3(3.999f, 1.5f, 0.2f), vec3(0, 1.2f, -3)},
        {"outside_of_all", {cube(0.3f)}, vec3(0, 4, 7), vec3(0, 1, 0)},
    };
}

FrameScene room_seen_by(const Eye& eye) {
    std::vector<Mesh> meshes = {box(vec3(-4, 0, -4), vec3(4, 3, 4), true, 0)};
    meshes.insert(meshes.end(), eye.things.begin(), eye.things.end());
    FrameScene scene = scene_of(meshes, {lambertian(vec3(0.5f)), lambertian(vec3(0.5f, 0.1f, 0.1f))},
                                {point_light(vec3(2, 2, 0), 300)}, eye.from, eye.to);
    scene.camera.camera.y_fov = 1.3f;
    const SceneChanges changes = scene.changes;
    for (std::uint32_t i = 1; i < scene.instances.size(); ++i) {
        move_instance(scene, i, eye.place);
    }
    scene.changes = changes;
    return scene;
}

void by_default(Bench& bench) {
    bench.settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    bench.settings.edit<EmcSettings>().rays = EmcRays::bvh;
    bench.settings.edit<EmcSettings>().gather_source = GatherSource::photons;
}

class EyesAnywhere : public testing::TestWithParam<Eye> {};

TEST_P(EyesAnywhere, SeeTheRoomAsPathDoes) {
    add_embree_rays();
    const FrameScene scene = room_seen_by(GetParam());
    const Truth truth = path_traced(scene, kSize, kBounces, kSpp);
    Bench bench;
    by_default(bench);
    const Deviation first = against(bench.frame(scene, kSize), truth);
    const Deviation off = against(still_picture(bench, scene, kFrames, kSize), truth);
    std::printf("%s: flux %.3f, then %.3f, relRMSE %.3f, then %.3f\n", GetParam().name, first.mean, off.mean,
                first.rel_rmse, off.rel_rmse);
    EXPECT_NEAR(first.mean, 1, 2 * kFlux);
    EXPECT_NEAR(off.mean, 1, kFlux);
    EXPECT_LT(off.rel_rmse, kError);
}

INSTANTIATE_TEST_SUITE_P(Eyes, EyesAnywhere, testing::ValuesIn(eyes()),
                         [](const auto& info) { return std::string(info.param.name); });

// The eye flies into a box and out of it on the other side: no frame is darker than the room is.
TEST(EyesAnywhere, FlyThroughAThing) {
    add_embree_rays();
    const Eye eye = eyes().front();
    FrameScene scene = room_seen_by(eye);
    Bench bench;
    by_default(bench);
    double least = 1e30, most = 0;
    for (int f = 0; f < 24; ++f) {
        const vec3 from(0, 1.5f, 1.2f - 0.1f * static_cast<float>(f));
        support::look(scene, from, from + vec3(-3, 0, 0));
        double sum = 0;
        for (const float v : bench.frame(scene, kSize).pixels) {
            sum += static_cast<double>(v);
        }
        least = std::min(least, sum);
        most = std::max(most, sum);
        hold_still(scene);
        scene.changes.camera = true;
    }
    std::printf("through a box: the darkest frame has %.3f of the brightest\n", least / most);
    EXPECT_GT(least, 0.5 * most);
}

}  // namespace
}  // namespace lanthorn::gi::test
