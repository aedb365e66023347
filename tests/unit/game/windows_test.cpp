// Windows of the game's levels: light goes through them, and no camera.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lanthorn/physics/physics.h"
#include "tests/support/scene_names.h"
#include "tests/unit/game/test_level.h"

namespace lanthorn::game {
namespace {

class Windows : public testing::TestWithParam<scene_generator::NamedScene> {};

TEST_P(Windows, LetNoCameraThrough) {
    constexpr double kCamera = 0.16;  // metres, its ball's radius
    const SceneData scene = GetParam().make();
    Played game(scene);
    game.steps(1);  // then bodies are there
    const physics::Physics& physics = *game.world().resource<std::shared_ptr<physics::Physics>>();
    std::vector<ecs::Entity> open;  // what may stand before a window, and may not
    for (const NodeData& node : scene.nodes) {
        if (node.name == "shutter") {
            open.push_back(game.named("shutter"));
        }
    }
    int windows = 0;
    for (const NodeData& node : scene.nodes) {
        if (!node.name.ends_with("-opening")) {
            continue;
        }
        ++windows;
        const dvec3 window = node.local.translation;
        // The room's middle is the origin, and the window is in one of its four walls.
        const dvec3 out = std::abs(window.x) > std::abs(window.z) ? dvec3(std::copysign(1.0, window.x), 0, 0)
                                                                  : dvec3(0, 0, std::copysign(1.0, window.z));
        const physics::Sweep sweep =
            physics.sweep_sphere(window - 0.8 * out, window + 0.8 * out, kCamera, open);
        // The wall is 0.3 m thick: the ball stops inside of it.
        EXPECT_TRUE(sweep.met) << node.name;
        EXPECT_NEAR(1.6 * sweep.share, 0.8 - 0.15 - kCamera, 1e-2) << node.name;
    }
    EXPECT_GE(windows, 1);
}

// What tools show of a level without being told is its establishing camera's view, not that from below her
// hat.
TEST_P(Windows, TheFirstCameraIsTheEstablishingOne) {
    const SceneData scene = GetParam().make();
    const auto first =
        std::ranges::find_if(scene.nodes, [](const NodeData& node) { return node.camera != kNone; });
    ASSERT_NE(first, scene.nodes.end());
    EXPECT_EQ(first->name, "camera");
}

INSTANTIATE_TEST_SUITE_P(Levels, Windows, testing::ValuesIn(scene_generator::level_scenes()),
                         support::scene_name);

}  // namespace
}  // namespace lanthorn::game
