// What stands before her fades, as she does right before the camera; figures alone have a rim.
#include "game/rules/looks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "game/rules/figures.h"
#include "lanthorn/runtime/view.h"
#include "lanthorn/scene/frame_scene.h"
#include "tests/unit/game/test_level.h"
#include "tools/scene_generator/hero_figure.h"

namespace lanthorn::game {
namespace {

// She looks along +X from x = -2; a thin pillar stands far away.
SceneData level_with_pillar() {
    scene_generator::Builder level = test_level();
    for (std::uint32_t i = 0; i < level.scene.nodes.size(); ++i) {
        if (level.scene.nodes[i].name == "player") {
            scene_generator::add_hero(level, i);
            break;
        }
    }
    level.solid("pillar", scene_generator::box({-0.05, 0, -0.05}, {0.05, 3, 0.05}), 0,
                scene_generator::kBoxCollider, scene_generator::at({-20, 0, 0}));
    return level.scene;
}

class LooksTest : public testing::Test {
  protected:
    Played game{level_with_pillar()};

    void SetUp() override { game.steps(60); }
    // What frames over half a second come to.
    float shown(const char* name) {
        for (int i = 0; i < 10; ++i) {
            game.session.app().frame(0.05);
        }
        const render::Look* look = game.world().resource<render::Looks>().find(game.named(name).index);
        return look != nullptr ? look->shown : 1;
    }
    dvec3 place_of(ecs::Entity e) { return dvec3(game.world().get<WorldTransform>(e).matrix[3]); }
    // Before her back, beside the way that the camera's ball has to its place.
    void put_pillar_between() {
        const dvec3 camera = place_of(game.named("view"));
        dvec3 between = glm::mix(camera, place_of(game.named("eyes")), 0.75);
        between.y = 0;
        game.world().get_mut<LocalTransform>(game.named("pillar")).value.translation = between;
    }
};

TEST(Looks, ComeAndGoInAQuarterOfASecond) {
    EXPECT_EQ(shown_from(0.3), 0);
    EXPECT_EQ(shown_from(2.3), 1);
    EXPECT_GT(shown_from(0.5), shown_from(0.4));
    EXPECT_FLOAT_EQ(faded(1, 0.25f, 0.05), 0.8f);
    EXPECT_FLOAT_EQ(faded(0.3f, 0.25f, 0.05), 0.25f);
    EXPECT_FLOAT_EQ(faded(0.5f, 1, 0.05), 0.7f);
    EXPECT_EQ(faded(1, 0.25f, 3), 0.25f);   // after a cut
    EXPECT_EQ(faded(1, 0.25f, -1), 0.25f);  // and backwards
}

TEST_F(LooksTest, FiguresHaveRimsAndNothingElseHas) {
    game.session.app().frame(1 / 60.0);
    int rims = 0;
    for (const render::Look& look : game.world().resource<render::Looks>().looks) {
        rims += look.rim ? 1 : 0;
        EXPECT_EQ(look.shown, 1);
    }
    EXPECT_GE(rims, 1);
    for (const char* name : {"floor", "wall", "door", "lantern", "pillar"}) {
        EXPECT_EQ(game.world().resource<render::Looks>().find(game.named(name).index), nullptr) << name;
    }
}

TEST_F(LooksTest, SheFadesRightBeforeTheCamera) {
    const auto hero = [&] {
        float least = 1;
        for (const render::Look& look : game.world().resource<render::Looks>().looks) {
            least = look.rim ? std::min(least, look.shown) : least;
        }
        return least;
    };
    shown("pillar");
    EXPECT_EQ(hero(), 1);
    // As if walls all around left it no more room.
    FollowCamera& camera = game.world().get_mut<FollowCamera>(game.named("view"));
    camera.distance = 0.4;
    camera.aside = camera.above = 0;
    game.steps(60);
    shown("pillar");
    EXPECT_LT(hero(), 0.9f);
    // Not so with her eyes: what would be seen of her is hands.
    game.press(kView);
    shown("pillar");
    EXPECT_EQ(hero(), 1);
}

TEST_F(LooksTest, WhatHidesHerFades) {
    EXPECT_EQ(shown("pillar"), 1);
    put_pillar_between();
    const float hidden = shown("pillar");
    EXPECT_GT(hidden, 0);
    EXPECT_LT(hidden, 0.5f);
    EXPECT_EQ(shown("wall"), 1);
    EXPECT_DOUBLE_EQ(game.of<FollowCamera>("view").back, game.of<FollowCamera>("view").distance);
    // Where something else is shown, nothing fades.
    game.session.app().view().placed = CameraView();
    EXPECT_EQ(shown("pillar"), 1);
}

}  // namespace
}  // namespace lanthorn::game
