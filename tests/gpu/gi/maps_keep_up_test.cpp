// The chosen maps after geometry has changed, held against maps chosen afresh: the area of all that some map
// sees.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "gi_module/reference/material_table.h"
#include "gi_module/reference/random.h"
#include "gi_module/reference/sampling.h"
#include "gi_module/reference/trace_scene.h"
#include "gi_module/techniques/emc/emc_technique.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/emc/emc_statistics.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(32);
constexpr int kTwoSeconds = 60;  // frames
constexpr double kKeepsUp = 0.98;

std::vector<vec3> centres_of(const EnvironmentMaps& maps) {
    std::vector<vec3> centres;
    for (const int member : maps.selected()) {
        centres.push_back(maps.centre(member));
    }
    return centres;
}

const EnvironmentMaps& maps_of(Bench& bench) {
    return dynamic_cast<const EmcTechnique&>(bench.technique()).maps();
}

// Where light is not looked at few photons will do: maps do not hang on them.
struct MapBench : Bench {
    MapBench() {
        settings.photons = 500;
        settings.bounces = 1;
    }
};

// What maps see of a scene, by exact rays: eq. 1 over maps of 32 x 32 counts the rims of what is far twice,
// up to half as much again as there is.
class Judge {
  public:
    // m^2 that are in sight of some centre, from the side that is seen.
    double area(const FrameScene& scene, const std::vector<vec3>& centres) {
        const reference::MaterialTable materials(*scene.assets);
        const reference::TraceScene traced(scene, materials);
        double sum = 0;
        for (std::uint32_t i = 0; i < traced.instances().size(); ++i) {
            const reference::TraceInstance& instance = traced.instances()[i];
            for (std::uint32_t t = 0; t < instance.mesh->indices.size() / 3; ++t) {
                const auto p = traced.corners(i, t);
                const double area =
                    0.5 * static_cast<double>(glm::length(glm::cross(p[1] - p[0], p[2] - p[0])));
                const reference::TraceTriangle& triangle = traced.triangles()[instance.first_triangle + t];
                for (int k = 0; k < kLooks; ++k) {
                    const float u = (static_cast<float>(k) + 0.5f) / kLooks;
                    const vec3 b = reference::triangle_point(
                        {u, reference::unit_float(reference::reverse_bits(static_cast<std::uint32_t>(k)))});
                    const vec3 from =
                        p[0] * b.x + p[1] * b.y + p[2] * b.z + triangle.normal * triangle.offset;
                    const bool seen = std::ranges::any_of(centres, [&](const vec3& centre) {
                        return glm::dot(triangle.normal, centre - from) > 0 &&
                               !traced.occluded(from, centre - from, false, reference::Blended::ignored);
                    });
                    sum += seen ? area / kLooks : 0;
                }
            }
        }
        return sum;
    }
    // The same of maps that are chosen now.
    double fresh(const FrameScene& scene, const GiSettings& settings) {
        gpu_scene_.update(scene);
        EnvironmentMaps maps;
        maps.select(scene, gpu_scene_, settings);
        count = maps.count();
        return area(scene, centres_of(maps));
    }
    int count = 0;  // of the last fresh choice

  private:
    static constexpr int kLooks = 256;  // a triangle
    render::GpuScene gpu_scene_;
};

// Frames of a scene that holds still from now on, after a change in the one that is shown first. Coverage, in
// shares of a fresh choice's, must get there and stay, and the work must end.
void expect_to_keep_up(const char* what, Bench& bench, FrameScene& scene) {
    Judge judge;
    const double fresh = judge.fresh(scene, bench.settings);
    int reached = -1;
    int last_change = 0;
    double coverage = judge.area(scene, centres_of(maps_of(bench))) / fresh;
    const double first = coverage;
    const int k_before = maps_of(bench).count();
    std::vector<vec3> centres = centres_of(maps_of(bench));
    double after_two_seconds = 0;
    int end = 0;
    for (int frame = 0; frame < 4 * kTwoSeconds && frame < end + 12; ++frame) {
        bench.show(scene, kSize);
        hold_still(scene);
        const GiPlan plan = bench.technique().statistics(false).plan;
        end = plan.on("coverage") || plan.on("progressive_update") ? frame + 1 : end;
        if (centres_of(maps_of(bench)) != centres || frame == 0) {
            centres = centres_of(maps_of(bench));
            coverage = judge.area(scene, centres) / fresh;
            last_change = frame;
            reached = coverage < kKeepsUp ? -1 : reached < 0 ? frame : reached;
        }
        after_two_seconds = frame <= kTwoSeconds ? coverage : after_two_seconds;
    }
    std::printf(
        "%s: coverage %.3f of a fresh choice's before, %.3f after two seconds, %.3f at last; %.2f from frame "
        "%d on; %d maps, then %d, fresh "
        "%d; last change in frame %d, last look in frame %d\n",
        what, first, after_two_seconds, coverage, kKeepsUp, reached, k_before, maps_of(bench).count(),
        judge.count, last_change, end - 1);
    EXPECT_GE(after_two_seconds, kKeepsUp) << what;
    EXPECT_GE(coverage, kKeepsUp) << what;
    EXPECT_LT(end, 3 * kTwoSeconds) << what << ": a still scene is not looked at";
    EXPECT_LE(maps_of(bench).count(), bench.settings.of<EmcSettings>().count) << what;
    // What is still is not drawn, looked at or chosen.
    bench.show(scene, kSize, true);
    for (const auto& span : bench.spans) {
        EXPECT_TRUE(span.name != "selection" && span.name != "coverage" &&
                    span.name != "progressive_update" && span.name != "environment_maps")
            << span.name;
    }
}

constexpr vec3 kHall(8, 2.6f, 6);

// A hall with partitions that stand in a pile at the wall x = 0, and slide to where they make eight rooms.
struct Hall {
    Hall() {
        std::vector<Mesh> meshes = {box(vec3(0), kHall, true, 0)};
        for (int i = 0; i < 3; ++i) {
            const float x = 0.05f + 0.1f * static_cast<float>(i);
            meshes.push_back(box(vec3(x, 0, 0), vec3(x + 0.08f, kHall.y, kHall.z), false, 1));
        }
        meshes.push_back(
            box(vec3(0.35f, 0, 2.95f), vec3(kHall.x, 0.02f, 3.03f), false, 1));  // a wall that rises
        scene = scene_of(meshes, {lambertian(vec3(0.6f)), lambertian(vec3(0.5f, 0.5f, 0.6f))},
                         {point_light(vec3(7, 2.2f, 4.5f), 100)}, vec3(7.8f, 1.5f, 5.8f), vec3(6, 1, 4));
    }
    // 0: as they stand at first; 1: eight rooms.
    void slide(float share) {
        for (std::uint32_t i = 1; i < 4; ++i) {
            const float from = 0.05f + 0.1f * static_cast<float>(i - 1);
            const float way = share * (2.0f * static_cast<float>(i) - from);
            move_instance(scene, i, glm::translate(mat4(1), vec3(way, 0, 0)));
        }
        move_instance(scene, 4, glm::scale(mat4(1), vec3(1, 1 + share * 129, 1)));
    }
    FrameScene scene;
};

TEST(MapsKeepUp, WallsSlideIntoAnOpenRoom) {
    MapBench bench;
    Hall hall;
    bench.show(hall.scene, kSize);
    hold_still(hall.scene);
    const int open = maps_of(bench).count();
    for (int frame = 1; frame <= 30; ++frame) {
        hold_still(hall.scene);
        hall.slide(static_cast<float>(frame) / 30);
        bench.show(hall.scene, kSize);
    }
    hold_still(hall.scene);
    expect_to_keep_up("walls that have slid in", bench, hall.scene);
    EXPECT_GT(maps_of(bench).count(), open) << "more rooms need more maps";
}

TEST(MapsKeepUp, WallsStandInAnOpenRoomFromOneFrameToTheNext) {
    MapBench bench;
    Hall hall;
    bench.show(hall.scene, kSize);
    hold_still(hall.scene);
    hall.slide(1);
    expect_to_keep_up("walls at once", bench, hall.scene);
}

// A corridor with a lamp and a door, behind which three cells lie, each open to the next one.
TEST(MapsKeepUp, ADoorOpensInOneFrame) {
    std::vector<Mesh> meshes = {box(vec3(0), kHall, true, 0),
                                box(vec3(0, 0, 2), vec3(3.5f, kHall.y, 2.1f), false, 1),
                                box(vec3(4.5f, 0, 2), vec3(8, kHall.y, 2.1f), false, 1),
                                box(vec3(3, 0, 2.1f), vec3(3.1f, kHall.y, 5.2f), false, 1),
                                box(vec3(5.4f, 0, 2.9f), vec3(5.5f, kHall.y, 6), false, 1),
                                box(vec3(3.5f, 0, 2.02f), vec3(4.5f, kHall.y, 2.08f), false, 2)};
    FrameScene scene =
        scene_of(meshes, std::vector<Material>(3, lambertian(vec3(0.6f))),
                 {point_light(vec3(4, 2.2f, 0.5f), 100)}, vec3(0.3f, 1.5f, 0.3f), vec3(4, 1, 1));
    MapBench bench;
    bench.show(scene, kSize);
    hold_still(scene);
    const mat4 hinge = glm::translate(mat4(1), vec3(3.5f, 0, 2.05f));
    move_instance(scene, 5, hinge * glm::rotate(mat4(1), -0.5f * kPi, vec3(0, 1, 0)) * glm::inverse(hinge));
    expect_to_keep_up("a door that has opened", bench, scene);
}

// A room of six walls with a screen in it, a lamp and a camera; and, if `world` is above 0, a black box
// around it, whose half side is `world` metres.
struct Wagon {
    explicit Wagon(float world) {
        const vec3 size(4, 2.4f, 3);
        std::vector<Mesh> meshes;
        for (int axis = 0; axis < 3; ++axis) {
            for (const bool upper : {false, true}) {
                vec3 a(-0.1f), b = size + 0.1f;
                (upper ? a : b)[axis] = upper ? size[axis] : 0;
                meshes.push_back(box(a, b, false, 0));
            }
        }
        meshes.push_back(box(vec3(1.9f, 0, 0.5f), vec3(2, 2, 3), false, 0));
        parts = static_cast<std::uint32_t>(meshes.size());
        if (world > 0) {
            meshes.push_back(box(vec3(-world), vec3(world), true, 1));
        }
        scene = scene_of(meshes, {lambertian(vec3(0.6f)), lambertian(vec3(0))},
                         {point_light(vec3(1, 2, 2), 100)}, vec3(0.3f, 1.5f, 0.3f), vec3(2, 1, 1));
    }
    void drive_to(const vec3& at, bool with_camera) {
        for (std::uint32_t i = 0; i < parts; ++i) {
            move_instance(scene, i, glm::translate(mat4(1), at));
        }
        scene.bounds = {};
        for (const Instance& instance : scene.instances) {
            scene.bounds.add(instance.bounds);
        }
        scene.lights[0].position = at + vec3(1, 2, 2);
        scene.changes.lights = true;
        if (with_camera) {
            support::look(scene, at + vec3(0.3f, 1.5f, 0.3f), at + vec3(2, 1, 1));
            scene.changes.camera = true;
        }
    }
    FrameScene scene;
    std::uint32_t parts = 0;
};

// Half side of the world around the room, m; speed of the room, m a frame: a walk, a train.
struct Drive {
    float world, speed;
    bool with_camera;  // or it stays behind: its surroundings are not the room
};

std::string words(const Drive& drive) {
    return fmt::format("in_{:.0f}_m_at_{}{}", drive.world, drive.speed < 0.1f ? "a_walk" : "a_run",
                       drive.with_camera ? "" : "_camera_left_behind");
}

class DrivingRoom : public testing::TestWithParam<Drive> {};

TEST_P(DrivingRoom, IsSeenAllTheWay) {
    const auto [world, speed, with_camera] = GetParam();
    Wagon wagon(world);
    MapBench bench;
    bench.show(wagon.scene, kSize);
    Judge judge;
    double least = 1e9;
    int selections = 0;
    for (int frame = 1; frame <= kTwoSeconds; ++frame) {
        hold_still(wagon.scene);
        wagon.drive_to(speed * static_cast<float>(frame) * vec3(1, 0.1f, 0.3f), with_camera);
        bench.show(wagon.scene, kSize);
        selections += bench.technique().statistics(false).plan.on("selection") ? 1 : 0;
        if (frame % 20 == 3) {
            least = std::min(least, judge.area(wagon.scene, centres_of(maps_of(bench))) /
                                        judge.fresh(wagon.scene, bench.settings));
        }
    }
    hold_still(wagon.scene);
    const std::string what = fmt::format("room that drives {} ({:.3f} on its way, {} choices)",
                                         words(GetParam()), least, selections);
    EXPECT_GE(least, kKeepsUp) << what;
    EXPECT_EQ(selections, 0) << what;
    expect_to_keep_up(what.c_str(), bench, wagon.scene);
}

INSTANTIATE_TEST_SUITE_P(Worlds, DrivingRoom,
                         testing::Values(Drive{0, 0.03f, true}, Drive{0, 0.5f, true}, Drive{0, 0.5f, false},
                                         Drive{60, 0.5f, true}, Drive{3000, 0.03f, true},
                                         Drive{3000, 0.5f, true}),
                         [](const auto& info) { return words(info.param); });

// By either final stage light is where it is in a room that has never moved.
TEST(MapsKeepUp, ARoomThatDrivesIsLitAsOneThatStands) {
    for (const EmcFinal final_stage : {EmcFinal::splat, EmcFinal::gather}) {
        const auto mean = [](const ImageF& image) {
            double sum = 0;
            for (const float v : image.pixels) {
                sum += static_cast<double>(v);
            }
            return sum / static_cast<double>(image.pixels.size());
        };
        Bench standing;
        standing.settings.edit<EmcSettings>().final_stage = final_stage;
        standing.settings.edit<EmcSettings>().gather_endless = false;  // further ones come in later frames
        Wagon still(60);
        double expected = 0;
        for (int frame = 0; frame < 4; ++frame) {
            expected = mean(standing.frame(still.scene, ivec2(48)));
            hold_still(still.scene);
        }
        Bench bench;
        bench.settings = standing.settings;
        Wagon wagon(60);
        bench.show(wagon.scene, ivec2(48));
        double least = 1e9, most = 0;
        for (int frame = 1; frame <= 8; ++frame) {
            hold_still(wagon.scene);
            wagon.drive_to(0.3f * static_cast<float>(frame) * vec3(1, 0.1f, 0.3f), true);
            const double share = mean(bench.frame(wagon.scene, ivec2(48))) / expected;
            least = std::min(least, share);
            most = std::max(most, share);
        }
        std::printf("room that drives: light %.3f to %.3f of what it is at rest\n", least, most);
        EXPECT_GT(least, 0.95);
        EXPECT_LT(most, 1.05);
    }
}

// From one frame to the next, as when the origin of render space moves.
TEST(MapsKeepUp, ARoomIsElsewhere) {
    Wagon wagon(0);
    MapBench bench;
    bench.show(wagon.scene, kSize);
    hold_still(wagon.scene);
    wagon.drive_to(vec3(1000, 0, -200), true);
    expect_to_keep_up("room 1 km away", bench, wagon.scene);
}

// Three of its walls drive away from the others, so many metres a frame.
class RoomComesApart : public testing::TestWithParam<float> {};

TEST_P(RoomComesApart, MapsAreWhereTheWallsHaveGone) {
    Wagon wagon(0);
    MapBench bench;
    bench.show(wagon.scene, kSize);
    for (int frame = 1; frame <= 60; ++frame) {
        hold_still(wagon.scene);
        for (const std::uint32_t i : {1u, 3u, 5u}) {
            vec3 at(0);
            at[static_cast<int>(i) / 2] = GetParam() * static_cast<float>(frame);
            move_instance(wagon.scene, i, glm::translate(mat4(1), at));
            wagon.scene.bounds.add(wagon.scene.instances[i].bounds);
        }
        bench.show(wagon.scene, kSize);
    }
    hold_still(wagon.scene);
    expect_to_keep_up(fmt::format("room that has come apart at {} m a frame", GetParam()).c_str(), bench,
                      wagon.scene);
}

INSTANTIATE_TEST_SUITE_P(Speeds, RoomComesApart, testing::Values(0.05f, 0.15f),
                         [](const auto& info) { return fmt::format("{:.0f}_mm", 1000 * info.param); });

// An exchange takes no longer to come where fades are long or updates frequent.
TEST(MapsKeepUp, FadesDoNotSlowUpdates) {
    for (const auto& [interval, fade] : {std::pair(1, 60), std::pair(5, 4)}) {
        MapBench bench;
        bench.settings.edit<EmcSettings>().update_interval = interval;
        bench.settings.edit<EmcSettings>().fade_frames = fade;
        Hall hall;
        bench.show(hall.scene, kSize);
        hold_still(hall.scene);
        hall.slide(1);
        std::vector<int> changes;
        std::vector<vec3> centres = centres_of(maps_of(bench));
        for (int frame = 0; frame < 4 * interval; ++frame) {
            bench.show(hall.scene, kSize);
            hold_still(hall.scene);
            if (centres_of(maps_of(bench)) != centres) {
                centres = centres_of(maps_of(bench));
                changes.push_back(frame);
            }
        }
        ASSERT_GE(changes.size(), 2u);
        EXPECT_EQ(changes[0], interval + 1);
        EXPECT_EQ(changes[1], 2 * interval + 1);
    }
}

}  // namespace
}  // namespace lanthorn::gi::test
