// The generated scenes that move: written, imported, played and deformed.
#include <gtest/gtest.h>

#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "lanthorn/animation/animator.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/deformation/deformation.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"
#include "tools/scene_generator/glb_bytes.h"
#include "tools/scene_generator/scenes.h"
#include "tools/scene_generator/walk_cycle.h"

namespace lanthorn::scene_generator {
namespace {

SceneData imported(const SceneData& scene) {
    const auto path =
        std::filesystem::temp_directory_path() / ("lanthorn-scene-" + std::to_string(::getpid()) + ".glb");
    std::ofstream(path, std::ios::binary) << glb_bytes(scene);
    SceneData result = import_gltf(path);
    std::filesystem::remove(path);
    return result;
}

// A scene that plays its first clip.
struct Played {
    explicit Played(SceneData scene) {
        nodes = spawn(world, std::move(scene));
        holder = world.query<ecs::With<AnimationSet>>().single_entity();
        AnimationPlayer player;
        play(player, world.get<AnimationSet>(holder), 0);
        world.add(holder, std::move(player));
        show(0);
    }
    void show(double seconds) {
        world.get_mut<AnimationPlayer>(holder).layers[0].time = seconds;
        animator.animate(world, 0);
        transforms.update(world);
        deformation.update(world);
    }
    dvec3 place(const std::string& name) {
        return dvec3(world.get<WorldTransform>(find_by_name(world, name)).matrix[3]);
    }
    ecs::World world;
    std::vector<ecs::Entity> nodes;
    ecs::Entity holder;
    Animator animator;
    Transforms transforms;
    Deformation deformation;
};

class MovingScene : public testing::TestWithParam<const char*> {
  protected:
    static SceneData made() {
        for (const auto* scenes : {&all_scenes(), &large_scenes()}) {
            for (const NamedScene& scene : *scenes) {
                if (scene.name == GetParam()) {
                    return scene.make();
                }
            }
        }
        throw std::runtime_error("no such scene");
    }
};

TEST_P(MovingScene, ComesBackFromItsFile) {
    const SceneData before = made();
    const SceneData after = imported(before);
    EXPECT_TRUE(after.warnings.empty()) << after.warnings.front();
    EXPECT_EQ(after.nodes.size(), before.nodes.size());
    EXPECT_EQ(after.meshes.size(), before.meshes.size());
    EXPECT_EQ(after.triangle_count(), before.triangle_count());
    ASSERT_EQ(after.skins.size(), before.skins.size());
    for (std::size_t s = 0; s < after.skins.size(); ++s) {
        EXPECT_EQ(after.skins[s].inverse_binds, before.skins[s].inverse_binds);
    }
    ASSERT_EQ(after.animations.size(), before.animations.size());
    for (std::size_t a = 0; a < after.animations.size(); ++a) {
        EXPECT_EQ(after.animations[a].duration, before.animations[a].duration);
        ASSERT_EQ(after.animations[a].channels.size(), before.animations[a].channels.size());
        for (std::size_t c = 0; c < after.animations[a].channels.size(); ++c) {
            EXPECT_EQ(after.animations[a].channels[c].times, before.animations[a].channels[c].times);
            EXPECT_EQ(after.animations[a].channels[c].values, before.animations[a].channels[c].values);
        }
    }
}

// The last key is the first again.
TEST_P(MovingScene, LoopsWithoutAJump) {
    const SceneData scene = made();
    for (const AnimationClip& clip : scene.animations) {
        for (const AnimationChannel& c : clip.channels) {
            EXPECT_FLOAT_EQ(c.times.back(), clip.duration);
            const std::size_t part = c.interpolation == Interpolation::cubic_spline ? c.width : 0;
            const std::size_t key = c.interpolation == Interpolation::cubic_spline ? 3 * c.width : c.width;
            const float* first = c.values.data() + part;
            const float* last = c.values.data() + (c.times.size() - 1) * key + part;
            float along = 0;
            for (std::size_t i = 0; i < c.width; ++i) {
                along += first[i] * last[i];
            }
            const float sign = c.path == AnimationPath::rotation && along < 0 ? -1.0f : 1.0f;
            for (std::size_t i = 0; i < c.width; ++i) {
                EXPECT_NEAR(first[i], sign * last[i], 2e-5) << scene.nodes[c.node].name;
            }
        }
    }
}

// Whatever the moment: no deformation is refused, nothing leaves the room or stops being a number.
TEST_P(MovingScene, DeformsAtEveryMoment) {
    Played scene(made());
    Aabb still;
    scene.world.query<ecs::Read<MeshInstances>, ecs::Read<WorldTransform>, ecs::Without<DeformedMeshes>>()
        .each([&](const MeshInstances& instances, const WorldTransform& at) {
            const AssetStore& store = scene.world.resource<AssetStore>();
            for (const MeshHandle mesh : instances.meshes) {
                still.add(transformed(store.get(mesh).bounds, mat4(at.matrix)));
            }
        });
    std::size_t deformed = 0;
    for (const double seconds : {0.0, 0.4, 1.1, 2.7, 5.3}) {
        scene.show(seconds);
        for (const std::string& warning : scene.deformation.warnings()) {
            ADD_FAILURE() << warning;
        }
        scene.world.query<ecs::Read<DeformedMeshes>, ecs::Read<WorldTransform>>().each(
            [&](const DeformedMeshes& d, const WorldTransform& at) {
                for (const DeformedMesh& mesh : d.meshes) {
                    if (!mesh.vertices) {
                        continue;
                    }
                    ++deformed;
                    Aabb box = mesh.bounds;
                    if (d.skinned) {
                        box.lower += vec3(d.skinned_at);
                        box.upper += vec3(d.skinned_at);
                    } else {
                        box = transformed(box, mat4(at.matrix));
                    }
                    EXPECT_TRUE(glm::all(glm::greaterThan(box.lower, still.lower)));
                    EXPECT_TRUE(glm::all(glm::lessThan(box.upper, still.upper)));
                }
            });
    }
    EXPECT_EQ(deformed > 0, std::string(GetParam()) != "nave");  // where only a node moves
}

INSTANTIATE_TEST_SUITE_P(Scenes, MovingScene, testing::Values("puppet", "nave", "crowd", "pool"));

// While a foot is on the ground, it stays where it is: it goes back as fast as the figure goes forward.
TEST(WalkCycle, FeetOnTheGroundDoNotSlip) {
    const Legs legs;
    const double stride = 0.785;
    for (std::size_t side = 0; side < 2; ++side) {
        double last = 0;
        for (int k = 0; k <= 34; ++k) {  // flat on the ground for 0.35 of the cycle
            const double phase = k * 0.01 + 0.5 * static_cast<double>(side);
            const WalkPose pose = walk_pose(phase - std::floor(phase), stride, legs);
            const double thigh = pose.thigh[side], shin = thigh + pose.shin[side];
            const double ahead = -legs.thigh * std::sin(thigh) - legs.shin * std::sin(shin);
            const double height =
                legs.hip + pose.lift - legs.thigh * std::cos(thigh) - legs.shin * std::cos(shin);
            EXPECT_NEAR(height, legs.ankle, 1e-6) << "phase " << phase;
            if (k > 0) {
                EXPECT_NEAR(last - ahead, 0.01 * stride, 1e-6) << "phase " << phase;
            }
            last = ahead;
        }
    }
}

TEST(WalkCycle, KneesBendForwardAlone) {
    for (int k = 0; k < 100; ++k) {
        const WalkPose pose = walk_pose(k * 0.01, 0.785, {});
        for (std::size_t side = 0; side < 2; ++side) {
            EXPECT_GE(pose.shin[side], 0);
            EXPECT_LT(pose.shin[side], 1.6);
        }
    }
}

TEST(Puppet, WalksRoundWithTheLanternBeforeIt) {
    Played scene(puppet());
    double lowest = 10, highest = 0;
    for (double seconds = 0; seconds < 10; seconds += 0.25) {
        scene.show(seconds);
        const dvec3 hips = scene.place("puppet.hips");
        EXPECT_NEAR(std::hypot(hips.x, hips.z), 1.25, 0.05);
        const dvec3 light = scene.place("lantern-light");
        EXPECT_GT(light.y, 0.6);
        EXPECT_LT(light.y, 1.2);
        const double angle = std::atan2(hips.x, hips.z);
        const dvec3 ahead(std::cos(angle), 0, -std::sin(angle));
        EXPECT_GT(glm::dot(light - hips, ahead), 0.2);
        for (const char* foot : {"puppet.foot.l", "puppet.foot.r"}) {
            lowest = std::min(lowest, scene.place(foot).y);
            highest = std::max(highest, scene.place(foot).y);
        }
    }
    EXPECT_NEAR(lowest, 0.08, 0.01);  // the ankle's height over the floor
    EXPECT_LT(highest, 0.25);
}

}  // namespace
}  // namespace lanthorn::scene_generator
