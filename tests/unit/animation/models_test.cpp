// Real models, played by the engine and by the tests' own evaluator. LANTHORN_MODELS names the folder of
// shared models.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>

#include "lanthorn/animation/animator.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/spawn.h"
#include "tests/unit/animation/gltf_evaluator.h"

namespace animation_test {
namespace {

using namespace lanthorn;
namespace fs = std::filesystem;

class Models : public testing::Test {
  protected:
    void SetUp() override {
        const char* folder = std::getenv("LANTHORN_MODELS");
        if (folder == nullptr) {
            GTEST_SKIP() << "LANTHORN_MODELS is not set: the folder of shared models";
        }
        models_ = folder;
    }
    fs::path models_;
};

// Which properties of which glTF node an animation moves.
std::set<std::pair<std::size_t, std::string>> moved(const nlohmann::json& animation) {
    std::set<std::pair<std::size_t, std::string>> found;
    for (const auto& channel : animation["channels"]) {
        const auto& target = channel["target"];
        if (target.contains("node")) {
            found.emplace(target["node"].get<std::size_t>(), target["path"].get<std::string>());
        }
    }
    return found;
}

template <class Found, class Expected>
void expect_close(const Found& found, const Expected& expected, std::size_t count, const char* what) {
    double largest = 1;
    for (std::size_t i = 0; i < count; ++i) {
        largest = std::max(largest, std::abs(expected[i]));
    }
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_NEAR(found[static_cast<int>(i)], expected[i], 1e-6 * largest) << what << " number " << i;
    }
}

void compare(const ecs::World& world, ecs::Entity entity, const NodePose& expected,
             const std::set<std::pair<std::size_t, std::string>>& targets, std::size_t node) {
    const Transform& local = world.get<LocalTransform>(entity).value;
    if (targets.contains({node, "translation"})) {
        expect_close(local.translation, expected.translation, 3, "translation");
    }
    if (targets.contains({node, "scale"})) {
        expect_close(local.scale, expected.scale, 3, "scale");
    }
    if (targets.contains({node, "rotation"})) {
        const quat& q = local.rotation;
        const auto& e = expected.rotation;
        EXPECT_NEAR(std::abs(q.x * e[0] + q.y * e[1] + q.z * e[2] + q.w * e[3]), 1, 1e-6) << "rotation";
        // The hemisphere, too: a keyed quaternion comes out as it is in the file.
        const vec4 found(q.x, q.y, q.z, q.w);
        expect_close(found, e, 4, "rotation");
    }
    if (targets.contains({node, "weights"})) {
        const auto& weights = world.get<MorphWeights>(entity).weights;
        ASSERT_EQ(weights.size(), expected.weights.size());
        for (std::size_t i = 0; i < weights.size(); ++i) {
            EXPECT_NEAR(weights[i], expected.weights[i], 1e-6);
        }
    }
}

// Plays every animation of the file at its keys, between them, and outside. Returns the number of poses.
std::size_t compare_file(const fs::path& file) {
    SCOPED_TRACE(file.string());
    const GltfEvaluator evaluator(file);
    ecs::World world;
    const std::vector<ecs::Entity> entities = spawn(world, import_gltf(file));
    const std::vector<std::size_t> walk = evaluator.walk();
    EXPECT_EQ(entities.size(), walk.size());
    const ecs::Entity holder = world.query<ecs::With<AnimationSet>>().single_entity();
    world.add(holder, AnimationPlayer{});
    const AnimationSet set = world.get<AnimationSet>(holder);
    EXPECT_EQ(set.clips->size(), evaluator.document()["animations"].size());
    Animator animator;
    std::size_t poses = 0;
    for (std::uint32_t a = 0; a < set.clips->size(); ++a) {
        const std::vector<double> keys = evaluator.key_times(a);
        EXPECT_NEAR((*set.clips)[a].duration, keys.back(), 1e-6);
        std::vector<double> times = {0, keys.back() + 1};
        for (std::size_t k = 0; k < keys.size(); ++k) {
            times.push_back(keys[k]);
            if (k > 0) {
                times.push_back(keys[k - 1] + 0.37 * (keys[k] - keys[k - 1]));
            }
        }
        const auto targets = moved(evaluator.document()["animations"][a]);
        for (const double time : times) {
            SCOPED_TRACE(testing::Message() << "animation " << a << " at " << time << " s");
            play(world.get_mut<AnimationPlayer>(holder), set, a, LoopMode::once).time = time;
            animator.animate(world, 0);
            const std::vector<NodePose> expected = evaluator.evaluate(a, time);
            for (std::size_t i = 0; i < walk.size(); ++i) {
                compare(world, entities[i], expected[walk[i]], targets, walk[i]);
                if (testing::Test::HasFailure()) {
                    return poses;
                }
            }
            ++poses;
        }
    }
    return poses;
}

TEST_F(Models, Fox) {
    EXPECT_GT(compare_file(models_ / "bevy/Fox.glb"), 100u);
}

TEST_F(Models, MorphStressTest) {
    EXPECT_GT(compare_file(models_ / "bevy/MorphStressTest.gltf"), 100u);
}

TEST_F(Models, SimpleSkin) {
    EXPECT_GT(compare_file(models_ / "bevy/SimpleSkin.gltf"), 10u);
}

// All others that have an animation and no error, and whose animation the engine plays whole.
TEST_F(Models, EveryOtherAnimatedFile) {
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(models_)) {
        const fs::path ending = entry.path().extension();
        if (ending != ".gltf" && ending != ".glb") {
            continue;
        }
        SceneData scene;
        try {
            scene = import_gltf(entry.path());
        } catch (const InputError&) {
            continue;
        }
        const bool whole =
            std::none_of(scene.warnings.begin(), scene.warnings.end(), [](const std::string& w) {
                return w.starts_with("/animations") || w.find("channel") != std::string::npos;
            });
        if (scene.animations.empty() || scene.nodes.empty() || !whole) {
            continue;  // without nodes there is nothing to play it
        }
        std::cout << entry.path().filename().string() << ": " << compare_file(entry.path()) << " poses\n";
        ++files;
    }
    EXPECT_GE(files, 5u);
}

}  // namespace
}  // namespace animation_test
