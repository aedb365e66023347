// Flames waver by the time that is shown, and in the picture alone.
#include "game/rules/flames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lanthorn/scene/components.h"
#include "tests/unit/game/test_level.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::game {
namespace {

Light candle() {
    Light light;
    light.colour = vec3(1, 0.7f, 0.4f);
    light.intensity = 20;
    return light;
}

TEST(Flames, AreTheSameWheneverAskedAndNoTwoAlike) {
    const Flame flame;
    const render::Glow now = flame_at(flame, candle(), dvec3(1, 2, 3), 5, 12.34);
    EXPECT_EQ(now, flame_at(flame, candle(), dvec3(1, 2, 3), 5, 12.34));
    EXPECT_FALSE(now == flame_at(flame, candle(), dvec3(1, 2, 3), 6, 12.34));
    EXPECT_FALSE(now == flame_at(flame, candle(), dvec3(1, 2, 3), 5, 12.4));
}

// In 20 seconds at 60 a second: steady as a flame, neither still nor blinking.
TEST(Flames, WaverWithinBoundsAndWithoutJumps) {
    const Flame flame;
    const render::Glow still = still_flame(flame, candle(), dvec3(0));
    float least = 1e9f, most = 0, sum = 0, jump = 0, before = 0;
    constexpr int kFrames = 1200;
    for (int i = 0; i < kFrames; ++i) {
        const render::Glow glow = flame_at(flame, candle(), dvec3(0), 1, i / 60.0);
        const float share = glow.nits.r / still.nits.r;
        EXPECT_EQ(glow.foot, still.foot);
        EXPECT_LE(glm::distance(glow.tip, still.tip), 0.3 * flame.height);
        EXPECT_NEAR(glow.nits.b / glow.nits.r, 0.4f, 1e-5f);  // its hue stays
        least = std::min(least, share);
        most = std::max(most, share);
        sum += share;
        jump = i > 0 ? std::max(jump, std::abs(share - before)) : 0;
        before = share;
    }
    EXPECT_GE(least, 1 - static_cast<float>(flame.flicker));
    EXPECT_LE(most, 1 + static_cast<float>(flame.flicker));
    EXPECT_GT(most - least, static_cast<float>(flame.flicker));
    EXPECT_NEAR(sum / kFrames, 1, 0.01);
    EXPECT_LT(jump, 0.4f * static_cast<float>(flame.flicker));
}

// What a frame shows, a sixtieth of a second after the one before.
std::vector<render::Glow> shown(Played& game, bool flicker) {
    game.world().resource_mut<Flicker>().on = flicker;
    game.session.app().frame(1 / 60.0);
    return game.world().resource<render::Glows>().glows;
}

TEST(Flames, AreSeenOfLightsThatShineAndStandStillIfAskedTo) {
    Played game(scene_generator::level_red_wall());
    const std::vector<render::Glow> one = shown(game, true), two = shown(game, true);
    ASSERT_EQ(one.size(), 1u);
    ASSERT_EQ(two.size(), 1u);
    EXPECT_FALSE(one == two);
    EXPECT_EQ(one.front().foot, two.front().foot);
    EXPECT_EQ(shown(game, false), shown(game, false));
    game.world().remove<LightComponent>(game.named("lantern-light"));
    EXPECT_TRUE(shown(game, true).empty());
}

TEST(Flames, LeaveTheLightAlone) {
    Played game(scene_generator::level_red_wall());
    const Light before = game.of<LightComponent>("lantern-light").light;
    for (int i = 0; i < 10; ++i) {
        shown(game, true);
        ASSERT_EQ(game.of<LightComponent>("lantern-light").light, before);
    }
}

}  // namespace
}  // namespace lanthorn::game
