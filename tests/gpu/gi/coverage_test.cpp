// Eq. 1 of Yao et al. 2010 against areas known by construction, and candidates in and out of solids.
#include "gi_module/techniques/emc/maps/coverage.h"

#include <gtest/gtest.h>

#include <numeric>

#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

struct Room {
    explicit Room(const FrameScene& the_scene) : scene(the_scene) {
        context();
        gpu_scene = std::make_unique<render::GpuScene>();
        gpu_scene->update(scene);
    }
    FrameScene scene;
    std::unique_ptr<render::GpuScene> gpu_scene;
};

Room empty_room() {
    return Room(scene_of({box(vec3(0), vec3(4, 2, 3), true, 0)}, {lambertian(vec3(0.5f))}, {}, vec3(2, 1, 1),
                         vec3(2, 1, 0)));
}

void draw(CoverageMeter& meter, const Room& room, const std::vector<vec3>& centres) {
    meter.place(centres);
    std::vector<int> all(centres.size());
    std::iota(all.begin(), all.end(), 0);
    meter.draw(room.scene, *room.gpu_scene, all);
}

TEST(Coverage, AViewerInAnEmptyRoomSeesItsWholeArea) {
    Room room = empty_room();
    CoverageMeter meter;
    const std::vector<vec3> centres{vec3(2, 1, 1.5f), vec3(1, 0.5f, 1), vec3(3.5f, 1.7f, 2.6f)};
    draw(meter, room, centres);
    const double area = 2 * (4 * 2 + 4 * 3 + 2 * 3);
    for (const Coverage& c : meter.measure({0, 1, 2}, {})) {
        EXPECT_NEAR(c.area / area, 1.0, 0.06);  // 32x32x6 pixels; grazing ones are cut short
        EXPECT_NEAR(c.seen_share, 1.0, 0.01);
        EXPECT_LT(c.back_share, 1e-6);
    }
    // What one sees whole, another adds nothing to.
    for (const Coverage& c : meter.measure({1, 2}, {0})) {
        EXPECT_LT(c.area / area, 0.03);
    }
}

TEST(Coverage, AScreenHidesWhatIsBehindIt) {
    // A wall across the room's middle: each half is seen from its own side alone.
    Room room(
        scene_of({box(vec3(0), vec3(4, 2, 2), true, 0), box(vec3(1.95f, 0, 0), vec3(2.05f, 2, 2), false, 0)},
                 {lambertian(vec3(0.5f))}, {}, vec3(1, 1, 1), vec3(0, 1, 1)));
    CoverageMeter meter;
    draw(meter, room, {vec3(1, 1, 1), vec3(3, 1, 1), vec3(2, 1, 1)});
    const double half = 1.95 * 2 * 4 + 2 * (2 * 2);
    const std::vector<Coverage> both = meter.measure({0, 1}, {0, 1});
    EXPECT_NEAR(both[0].area / half, 1.0, 0.06);
    EXPECT_NEAR(both[1].area / half, 1.0, 0.06);
    EXPECT_FALSE(in_the_open(meter.measure({2}, {})[0], room.scene.diagonal()));  // inside the wall
}

TEST(Coverage, TheFarSideOfAThinWallIsNotSeen) {
    // Ten centimetres of wall in a room of eight metres: less than the shadow test's tolerance in depth. Only
    // the way its sides face tells them apart.
    Room room(
        scene_of({box(vec3(0), vec3(8, 2, 2), true, 0), box(vec3(3.95f, 0, 0), vec3(4.05f, 2, 2), false, 0)},
                 {lambertian(vec3(0.5f))}, {}, vec3(1, 1, 1), vec3(0, 1, 1)));
    CoverageMeter meter;
    draw(meter, room, {vec3(0.6f, 1, 1), vec3(7.4f, 1, 1)});
    const double half = 3.95 * 2 * 4 + 2 * (2 * 2);
    const std::vector<Coverage> both = meter.measure({0, 1}, {0, 1});
    EXPECT_NEAR(both[0].area / half, 1.0, 0.06);
    EXPECT_NEAR(both[1].area / half, 1.0, 0.06);
}

TEST(Coverage, GrazingViewsStayFinite) {
    // A centre a hair above the floor: (v - x).n is nearly 0 for most of what it sees.
    Room room = empty_room();
    CoverageMeter meter;
    draw(meter, room, {vec3(2, 1e-4f, 1.5f)});
    const Coverage c = meter.measure({0}, {})[0];
    EXPECT_TRUE(std::isfinite(c.area));
    EXPECT_LT(c.area, 2.0 * 2 * (4 * 2 + 4 * 3 + 2 * 3));
    EXPECT_FALSE(in_the_open(c, room.scene.diagonal()));
}

TEST(Selection, CandidatesStayOutOfSolids) {
    // A block fills half the room: no candidate may lie in it, and one map is enough for what is left.
    Room room(scene_of({box(vec3(0), vec3(4, 2, 2), true, 0), box(vec3(2, 0, 0), vec3(4, 2, 2), false, 0)},
                       {lambertian(vec3(0.5f))}, {}, vec3(1, 1, 1), vec3(0, 1, 1)));
    EnvironmentMaps maps;
    GiSettings settings;
    maps.select(room.scene, *room.gpu_scene, settings);
    ASSERT_EQ(maps.candidates().size(), static_cast<std::size_t>(settings.of<EmcSettings>().candidates));
    for (const vec3& c : maps.candidates()) {
        EXPECT_LT(c.x, 2.0f);
    }
    EXPECT_LT(maps.count(), settings.of<EmcSettings>().count);
    EXPECT_GT(maps.statistics().coverage, 0.99);
    EXPECT_LE(maps.statistics().refinement_steps, 5);  // Yao et al. 2010, sec. 4.1: 2 to 5
}

}  // namespace
}  // namespace lanthorn::gi::test
