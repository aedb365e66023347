// Levels of more rooms than k maps can show: which centres there are, and which maps a camera gets that walks
// from room to room.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "gi_module/shared/rays/embree_rays.h"
#include "gi_module/techniques/emc/emc_technique.h"
#include "gi_module/techniques/emc/maps/candidates.h"
#include "gi_module/techniques/emc/maps/centre_pool.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/emc/emc_statistics.h"
#include "tests/gpu/gi/path_truth.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr float kRoom = 4, kHeight = 2.5f;  // m, from wall to wall

// Walls of 20 cm round a room whose inside begins at `lower`.
void add_room(std::vector<Mesh>& meshes, const vec3& lower) {
    const vec3 size(kRoom, kHeight, kRoom);
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool upper : {false, true}) {
            vec3 a = lower - 0.2f, b = lower + size + 0.2f;
            (upper ? a : b)[axis] = upper ? lower[axis] + size[axis] : lower[axis];
            meshes.push_back(box(a, b, false, 0));
        }
    }
}

bool in_room(const vec3& p, const vec3& lower) {
    return glm::all(glm::greaterThan(p, lower)) &&
           glm::all(glm::lessThan(p, lower + vec3(kRoom, kHeight, kRoom)));
}

const vec3 kFar(40, 20, 40);  // 60 m

FrameScene far_apart() {
    std::vector<Mesh> meshes;
    add_room(meshes, vec3(0));
    add_room(meshes, kFar);
    return scene_of(meshes, {lambertian(vec3(0.6f))},
                    {point_light(vec3(2, 2, 2), 60), point_light(kFar + vec3(2, 2, 2), 60)},
                    vec3(0.5f, 1.5f, 0.5f), vec3(3, 1, 3));
}

TEST(CentrePool, HasCentresInRoomsThatABoxOfCandidatesMisses) {
    const FrameScene scene = far_apart();
    const auto in_either = [](const std::vector<vec3>& points) {
        return std::ranges::count_if(points, [](const vec3& p) { return in_room(p, vec3(0)); }) *
               std::ranges::count_if(points, [](const vec3& p) { return in_room(p, kFar); });
    };
    EXPECT_EQ(in_either(candidate_points(scene.bounds, 0, 40, 1)), 0);
    CentrePool pool(scene, scene.bounds);
    pool.fill(1);
    EXPECT_GE(in_either(pool.centres()), 4);
    // From within a room nothing else is reached.
    const auto reached = pool.reach(kFar + vec3(1, 1, 1), 40);
    ASSERT_FALSE(reached.empty());
    for (const CentrePool::Reached& r : reached) {
        EXPECT_TRUE(in_room(pool.centres()[static_cast<std::size_t>(r.centre)], kFar));
    }
}

// A row of rooms along +x, each with a doorway of 1 m to the next, every other one with a lamp. If `door`,
// the last mesh closes that of room 0.
FrameScene row_of_rooms(int rooms, bool door = false) {
    const float end = static_cast<float>(rooms) * (kRoom + 0.2f);
    std::vector<Mesh> meshes = {
        box(vec3(-0.2f, -0.2f, -0.2f), vec3(end, 0, kRoom + 0.2f), false, 0),
        box(vec3(-0.2f, kHeight, -0.2f), vec3(end, kHeight + 0.2f, kRoom + 0.2f), false, 0),
        box(vec3(-0.2f, 0, -0.2f), vec3(end, kHeight, 0), false, 1),
        box(vec3(-0.2f, 0, kRoom), vec3(end, kHeight, kRoom + 0.2f), false, 2),
        box(vec3(-0.2f, 0, 0), vec3(0, kHeight, kRoom), false, 0)};
    std::vector<LightInstance> lamps;
    for (int r = 0; r < rooms; ++r) {
        const float x = static_cast<float>(r) * (kRoom + 0.2f) + kRoom;
        if (r + 1 == rooms) {
            meshes.push_back(box(vec3(x, 0, 0), vec3(x + 0.2f, kHeight, kRoom), false, 0));
        } else {
            const float z = r % 2 == 0 ? 0.5f : 2.5f;  // no view through more than two
            meshes.push_back(box(vec3(x, 0, 0), vec3(x + 0.2f, kHeight, z), false, 0));
            meshes.push_back(box(vec3(x, 0, z + 1), vec3(x + 0.2f, kHeight, kRoom), false, 0));
            meshes.push_back(box(vec3(x, 2, z), vec3(x + 0.2f, kHeight, z + 1), false, 0));
        }
        if (r % 2 == 0) {
            lamps.push_back(point_light(vec3(x - 2.2f, 2.1f, 2), 60));
            lamps.back().id = static_cast<std::uint32_t>(r + 1);
        }
    }
    if (door) {
        meshes.push_back(box(vec3(kRoom + 0.05f, 0, 0.5f), vec3(kRoom + 0.15f, 2, 1.5f), false, 0));
    }
    return scene_of(
        meshes,
        {lambertian(vec3(0.65f)), lambertian(vec3(0.6f, 0.3f, 0.25f)), lambertian(vec3(0.3f, 0.4f, 0.6f))},
        lamps, vec3(0.6f, 1.5f, 3.4f), vec3(3, 1, 1));
}

TEST(CentrePool, WaysLeadThroughDoorwaysAndDoorsThatHaveMoved) {
    const auto rooms_reached = [](const CentrePool& pool) {
        int most = 0;
        for (const CentrePool::Reached& r : pool.reach(vec3(1, 1.5f, 1), 40)) {
            const float x = pool.centres()[static_cast<std::size_t>(r.centre)].x;
            most = std::max(most, static_cast<int>(x / (kRoom + 0.2f)));
        }
        return most;
    };
    const FrameScene open = row_of_rooms(4);
    CentrePool pool(open, open.bounds);
    pool.fill(1);
    EXPECT_GE(rooms_reached(pool), 2);
    FrameScene shut = row_of_rooms(4, true);
    CentrePool behind(shut, shut.bounds);
    behind.fill(1);
    EXPECT_EQ(rooms_reached(behind), 0);
    const auto leaf = static_cast<std::uint32_t>(shut.instances.size() - 1);
    hold_still(shut);
    move_instance(shut, leaf, glm::translate(mat4(1), vec3(0, 0, 1)));
    EXPECT_TRUE(behind.leave_out(shut, shut.changes.moved));
    EXPECT_GT(rooms_reached(behind), 1);
    EXPECT_FALSE(behind.leave_out(shut, shut.changes.moved)) << "it has been left out";
}

constexpr ivec2 kSize(48);
constexpr int kBounces = 2;

GiSettings settings() {
    GiSettings settings;
    settings.bounces = kBounces;
    // Maps that come back bring their rays with them; photons begin again there.
    settings.edit<EmcSettings>().gather_source = GatherSource::rays;
    settings.edit<EmcSettings>().gather_endless = false;
    settings.edit<EmcSettings>().gather_points = 1;
    settings.edit<EmcSettings>().gather_grid = 2;
    settings.edit<EmcSettings>().rays = EmcRays::bvh;
    return settings;
}

const EnvironmentMaps& maps_of(Bench& bench) {
    return dynamic_cast<const EmcTechnique&>(bench.technique()).maps();
}

TEST(ManyRooms, EachOfTwoFarRoomsIsLitWhereTheCameraIs) {
    add_embree_rays();
    FrameScene scene = far_apart();
    Bench bench;
    bench.settings = settings();
    for (const vec3& room : {vec3(0), kFar}) {
        support::look(scene, room + vec3(0.5f, 1.5f, 0.5f), room + vec3(3, 1, 3));
        const Deviation off = against(bench.frame(scene, kSize), path_traced(scene, kSize, kBounces, 256));
        std::printf("far rooms: relRMSE %.3f, flux %.3f\n", off.rel_rmse, off.mean);
        EXPECT_TRUE(maps_of(bench).many_rooms());
        EXPECT_NEAR(off.mean, 1, 0.08);
        EXPECT_LT(off.rel_rmse, 0.2);
        hold_still(scene);
        scene.changes.camera = true;
    }
}

TEST(ManyRooms, ALevelThatItsMapsShowIsChosenForAsBefore) {
    add_embree_rays();
    Bench bench;
    bench.settings = settings();
    bench.frame(row_of_rooms(2), kSize);
    EXPECT_FALSE(maps_of(bench).many_rooms());
}

EmcStatistics statistics_of(Bench& bench) {
    return bench.technique().statistics(false).of<EmcStatistics>();
}

struct Walk {
    // relRMSE where it begins: of a still camera, of one that has moved a little, and after the walk, before
    // and after the camera has rested.
    double steady = 0, moving = 0, returned = 0, back = 0;
    double darkest = 1e30;      // mean of a frame over that of the brightest
    std::size_t most_kept = 0;  // bytes
    std::vector<float> last;
};

// From room 0 along the row to its `rooms`-th and back, 7 cm a frame, and then still.
Walk walk(Bench& bench, int rooms) {
    constexpr int kStill = 40, kStepsARoom = 60;
    FrameScene scene = row_of_rooms(14);
    const vec3 start(0.6f, 1.5f, 3.4f), ahead(2.4f, -0.5f, -2.4f);
    support::look(scene, start, start + ahead);
    const Truth truth = path_traced(scene, kSize, kBounces, 512);
    ImageF image = bench.frame(scene, kSize);
    hold_still(scene);
    for (int f = 0; f < kStill; ++f) {
        image = bench.frame(scene, kSize);
    }
    Walk result;
    result.steady = against(image, truth).rel_rmse;
    scene.changes.camera = true;
    for (int f = 1; f <= kStepsARoom; ++f) {
        const vec3 aside(0.9f * static_cast<float>(kStepsARoom - f) / kStepsARoom, 0, 0);
        support::look(scene, start + aside, start + aside + ahead);
        image = bench.frame(scene, kSize);
    }
    result.moving = against(image, truth).rel_rmse;
    // Through the middles of rooms and doorways.
    std::vector<vec3> corners = {start};
    for (int r = 0; r < rooms; ++r) {
        const float x = static_cast<float>(r) * (kRoom + 0.2f) + kRoom + 0.1f;
        corners.emplace_back(x, 1.5f, r % 2 == 0 ? 1.0f : 3.0f);
        corners.emplace_back(x + 2, 1.5f, 2);
    }
    for (std::size_t c = corners.size() - 1; c-- > 0;) {
        corners.push_back(corners[c]);
    }
    const auto mean = [](const ImageF& i) {
        double sum = 0;
        for (const float v : i.pixels) {
            sum += static_cast<double>(v);
        }
        return sum / static_cast<double>(i.pixels.size());
    };
    double brightest = 0;
    std::vector<double> means;
    for (std::size_t c = 0; c + 1 < corners.size(); ++c) {
        for (int s = 1; s <= kStepsARoom / 2; ++s) {
            const vec3 eye = glm::mix(corners[c], corners[c + 1], static_cast<float>(s) / (kStepsARoom / 2));
            support::look(scene, eye, eye + ahead);
            image = bench.frame(scene, kSize);
            means.push_back(mean(image));
            result.most_kept = std::max(result.most_kept, statistics_of(bench).kept_bytes);
            brightest = std::max(brightest, means.back());
        }
    }
    for (const double m : means) {
        result.darkest = std::min(result.darkest, m / brightest);
    }
    result.returned = against(image, truth).rel_rmse;
    scene.changes.camera = false;
    for (int f = 0; f < kStill; ++f) {
        image = bench.frame(scene, kSize);
    }
    result.back = against(image, truth).rel_rmse;
    result.last = image.pixels;
    return result;
}

TEST(ManyRooms, AWalkThereAndBackIsNeverBlackAndEndsAsItBegan) {
    add_embree_rays();
    Bench bench;
    bench.settings = settings();
    const Walk there = walk(bench, 2);
    std::printf("walk: still %.4f, moving %.4f, on return %.4f, at rest %.4f, darkest frame %.3f\n",
                there.steady, there.moving, there.returned, there.back, there.darkest);
    EXPECT_TRUE(maps_of(bench).many_rooms());
    EXPECT_LT(there.returned, 1.3 * there.moving);  // measured: 1.21
    EXPECT_LT(there.back, 1.2 * there.steady);
    EXPECT_GT(there.darkest, 0.02);
    EXPECT_GT(statistics_of(bench).brought_back, 0u) << "maps that had been left behind";
    EXPECT_LE(there.most_kept, std::size_t{64} << 20);
}

TEST(ManyRooms, AWalkIsTheSameInEveryRun) {
    add_embree_rays();
    Bench once, again;
    once.settings = again.settings = settings();
    EXPECT_EQ(walk(once, 2).last, walk(again, 2).last);
}

// Cuts to the other end of the row and back.
TEST(ManyRooms, KeepsNoMoreMapsThanItsBudgetHolds) {
    add_embree_rays();
    Bench bench;
    bench.settings = settings();
    const auto cut_to = [&](FrameScene& scene, int room) {
        const vec3 eye(static_cast<float>(room) * (kRoom + 0.2f) + 0.6f, 1.5f, 3.4f);
        support::look(scene, eye, eye + vec3(2.4f, -0.5f, -2.4f));
        bench.frame(scene, kSize);
        hold_still(scene);
        scene.changes.camera = true;
        return statistics_of(bench);
    };
    FrameScene scene = row_of_rooms(14);
    cut_to(scene, 0);
    EXPECT_EQ(statistics_of(bench).kept, 0);
    EmcStatistics now = cut_to(scene, 13);
    EXPECT_GE(now.kept, 1);
    EXPECT_LE(now.kept_bytes, std::size_t{64} << 20);
    EXPECT_EQ(now.brought_back, 0u);
    now = cut_to(scene, 0);
    EXPECT_GE(now.brought_back, 1u);
    bench.settings.edit<EmcSettings>().kept = 8;
    now = cut_to(scene, 13);
    EXPECT_GE(now.kept, 1);
    EXPECT_LE(now.kept_bytes, std::size_t{8} << 20);
    bench.settings.edit<EmcSettings>().kept = 0;
    now = cut_to(scene, 0);
    EXPECT_EQ(now.kept, 0);
}

}  // namespace
}  // namespace lanthorn::gi::test
