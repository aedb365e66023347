// Fly, orbit and follow cameras against what a drawing on paper says.
#include "lanthorn/shell/cameras.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "lanthorn/scene/components.h"
#include "lanthorn/scene/hierarchy.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn::shell {
namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void expect_near(const dvec3& value, const dvec3& wanted, double within = 1e-12) {
    EXPECT_LE(glm::distance(value, wanted), within)
        << value.x << ' ' << value.y << ' ' << value.z << ", expected " << wanted.x << ' ' << wanted.y << ' '
        << wanted.z;
}

TEST(Gaze, LooksAlongMinusZAndTurnsToTheLeft) {
    Gaze gaze;
    expect_near(gaze.ahead(), {0, 0, -1});
    gaze.turn(kQuarter, 0);
    expect_near(gaze.ahead(), {-1, 0, 0});
    gaze.turn(0, 0.25 * std::numbers::pi);
    expect_near(gaze.ahead(), {-std::sqrt(0.5), std::sqrt(0.5), 0});
}

TEST(Gaze, StaysShortOfStraightUpAndWhole) {
    Gaze gaze;
    gaze.turn(0, 100);
    EXPECT_LT(gaze.pitch, kQuarter);
    EXPECT_GT(std::hypot(gaze.ahead().x, gaze.ahead().z), 1e-3);
    const Gaze before = gaze;
    gaze.turn(kNone, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(gaze, before);
    gaze.turn(1e9, 0);  // turned round very often
    EXPECT_LE(std::abs(gaze.yaw), std::numbers::pi);
}

TEST(Gaze, IsReadOffATransformAndPutsItBack) {
    for (const double yaw : {-3.0, -0.5, 0.0, 1.0, 3.1}) {
        for (const double pitch : {-1.5, -0.3, 0.0, 1.2}) {
            const Gaze gaze{yaw, pitch};
            const Gaze again = gaze_of(camera_at({1, 2, 3}, gaze));
            EXPECT_NEAR(again.yaw, yaw, 1e-9);
            EXPECT_NEAR(again.pitch, pitch, 1e-9);
        }
    }
}

TEST(Gaze, OfATransformWithoutDirectionIsAhead) {
    EXPECT_EQ(gaze_of(dmat4(0)), Gaze{});
    dmat4 down = dmat4(glm::dmat3({-1, 0, 0}, {0, 0, 1}, {0, 1, 0}));  // looks along -Y, its upper edge to +Z
    EXPECT_NEAR(std::abs(gaze_of(down).yaw), std::numbers::pi, 1e-9);
    EXPECT_LT(gaze_of(down).pitch, -1.5);
}

TEST(Gaze, WalksOverTheGroundWhereverItLooks) {
    const Gaze up{kQuarter, 1.4};
    expect_near(up.walk(0, 1), {-1, 0, 0});
    expect_near(up.walk(1, 0), {0, 0, -1});
    EXPECT_NEAR(glm::length(up.walk(1, 1)), 1, 1e-12);  // no faster askew
    EXPECT_NEAR(glm::length(up.walk(0.3, 0)), 0.3, 1e-12);
    expect_near(up.walk(kNone, 0), {0, 0, 0});
}

TEST(FlyCamera, FliesAtItsSpeedWhereItIsSteered) {
    FlyCamera fly{.gaze = {kQuarter, 0}, .speed = 4};
    fly.move({0, 0, 1}, 0.5);
    expect_near(fly.place, {-2, 0, 0});
    fly.move({1, 0, 0}, 0.5);
    expect_near(fly.place, {-2, 0, -2});
    fly.move({1, 1, 1}, 1);
    EXPECT_NEAR(glm::distance(fly.place, dvec3(-2, 0, -2)), 4, 1e-12);
    const dvec3 before = fly.place;
    fly.move({0, 0, 1}, kNone);
    expect_near(fly.place, before);
}

TEST(FlyCamera, MovesByMillimetresAHundredKilometresAway) {
    FlyCamera fly{.place = {1e5, 0, -1e5}, .speed = 1};
    for (int i = 0; i < 1000; ++i) {
        fly.move({0, 0, 1}, 0.001);
    }
    EXPECT_NEAR(fly.place.z, -1e5 - 1, 1e-8);
}

TEST(OrbitCamera, KeepsItsDistanceFromTheTarget) {
    OrbitCamera orbit{.target = {5, 1, 0}, .distance = 3};
    for (int i = 0; i < 50; ++i) {
        orbit.gaze.turn(0.3, 0.1);
        const dmat4 at = orbit.world();
        EXPECT_NEAR(glm::distance(dvec3(at[3]), orbit.target), 3, 1e-9);
        expect_near(dvec3(at[3]) - 3.0 * dvec3(at[2]), orbit.target, 1e-9);  // in the picture's middle
    }
}

TEST(OrbitCamera, ZoomHasEnds) {
    OrbitCamera orbit;
    orbit.zoom(1);
    EXPECT_NEAR(orbit.distance, 4.5, 1e-12);
    orbit.zoom(1e6);
    EXPECT_EQ(orbit.distance, OrbitCamera::kNearest);
    orbit.zoom(-1e6);
    EXPECT_EQ(orbit.distance, OrbitCamera::kFarthest);
    orbit.zoom(kNone);
    EXPECT_EQ(orbit.distance, OrbitCamera::kFarthest);
}

// What was at the picture's lower edge is in its middle after half a height.
TEST(OrbitCamera, PansByHeightsOfThePicture) {
    OrbitCamera orbit{.distance = 2};
    const double yfov = kQuarter;
    orbit.pan(0.5, -0.5, yfov);
    expect_near(orbit.target, {2, -2, 0});  // 2 tan 45 degrees
}

TEST(OrbitCamera, ShowsAllOfABoxInATallAndAWidePicture) {
    Aabb box;
    box.add(vec3(-1, -2, -3));
    box.add(vec3(1, 2, 3));
    for (const double aspect : {0.3, 1.0, 3.0}) {
        for (const double yaw : {0.0, 0.7, 2.0}) {
            OrbitCamera orbit{.gaze = {yaw, -0.4}};
            const double yfov = 0.9;
            orbit.show_all(box, {100, 0, 0}, yfov, aspect);
            const dmat4 view = glm::inverse(orbit.world());
            for (int corner = 0; corner < 8; ++corner) {
                const dvec3 at(corner & 1 ? 101 : 99, corner & 2 ? 2 : -2, corner & 4 ? 3 : -3);
                const dvec3 seen(view * dvec4(at, 1));
                EXPECT_LT(seen.z, 0);
                EXPECT_LE(std::abs(seen.y), -seen.z * std::tan(0.5 * yfov));
                EXPECT_LE(std::abs(seen.x), -seen.z * std::tan(0.5 * yfov) * aspect);
            }
        }
    }
}

TEST(OrbitCamera, ShowsNothingAsACubeOfTwoMetres) {
    OrbitCamera orbit;
    orbit.show_all(Aabb(), {1, 2, 3}, 1, 1);
    expect_near(orbit.target, {1, 2, 3});
    EXPECT_GT(orbit.distance, 1);
    EXPECT_LT(orbit.distance, 10);
}

TEST(FollowCamera, IsBehindAndAboveWhoStands) {
    FollowCamera follow;
    follow.follow({1, 0, 2}, kQuarter, 0);  // looks along -X
    expect_near(dvec3(follow.world()[3]), {4, 1.7, 2});
}

TEST(FollowCamera, GoesHalfOfTheWayInItsHalfLifeHoweverTimeIsCut) {
    FollowCamera once, often;
    once.follow({0, 0, 0}, 0, 0);
    often.follow({0, 0, 0}, 0, 0);
    once.follow({1, 0, 0}, 0.5, once.half_life);
    for (int i = 0; i < 7; ++i) {
        often.follow({1, 0, 0}, 0.5, often.half_life / 7);
    }
    const Gaze half{0.25, 0};
    expect_near(dvec3(once.world()[3]), dvec3(0.5, 1.7, 0) - 3.0 * half.ahead());
    expect_near(dvec3(often.world()[3]), dvec3(once.world()[3]));
}

TEST(FollowCamera, TurnsTheShortWayRound) {
    FollowCamera follow;
    follow.follow({}, 3.1, 0);
    follow.follow({}, -3.1, follow.half_life);
    EXPECT_NEAR(std::abs(gaze_of(follow.world()).yaw), std::numbers::pi, 1e-6);
}

TEST(FollowCamera, JumpsToWhoHasBeenPutElsewhere) {
    FollowCamera follow;
    follow.follow({0, 0, 0}, 0, 0);
    follow.follow({1000, 0, 0}, 0, 0.001);
    expect_near(dvec3(follow.world()[3]), {1000, 1.7, 3});
}

TEST(PlaceCamera, StandsThereWhateverItsParentsDo) {
    ecs::World world;
    const ecs::Entity car = world.create(
        LocalTransform{{.translation = {10, 0, 0}, .rotation = quat(vec3(0, 1, 0)), .scale = vec3(2)}});
    const ecs::Entity camera = world.create(LocalTransform{}, Parent{car});
    Transforms transforms;
    transforms.update(world);
    const dmat4 wanted = camera_at({1, 2, 3}, {0.3, -0.2});
    place_camera(world, camera, wanted);
    transforms.update(world);
    const dmat4& at = world.get<WorldTransform>(camera).matrix;
    expect_near(dvec3(at[3]), {1, 2, 3}, 1e-6);
    expect_near(glm::normalize(dvec3(at[2])), dvec3(wanted[2]), 1e-6);
}

TEST(PlaceCamera, LeavesItBelowAParentWithoutExtent) {
    ecs::World world;
    const ecs::Entity flat = world.create(LocalTransform{{.scale = vec3(0)}});
    const ecs::Entity camera = world.create(LocalTransform{}, Parent{flat});
    Transforms transforms;
    transforms.update(world);
    place_camera(world, camera, camera_at({1, 2, 3}, {}));
    EXPECT_EQ(world.get<LocalTransform>(camera), LocalTransform{});
}

}  // namespace
}  // namespace lanthorn::shell
