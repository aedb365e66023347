// What the first picture of each level shows once the camera has come to rest: the player, whole and not so
// near that her hat fills it, what she is to wake, and what she does it by.
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>
#include <vector>

#include "game/rules/figures.h"
#include "game/rules/looks.h"
#include "lanthorn/physics/physics.h"
#include "lanthorn/runtime/view.h"
#include "tests/support/scene_names.h"
#include "tests/unit/game/test_level.h"

namespace lanthorn::game {
namespace {

// A picture of 16:9, 56 degrees high.
class Picture {
  public:
    explicit Picture(const dmat4& camera) : to_camera_(glm::inverse(camera)) {}

    // Whether a point is within `share` of the way from the picture's middle to its edges.
    bool shows(const dvec3& point, double share) const {
        const dvec3 at(to_camera_ * dvec4(point, 1));
        const double up = std::tan(0.5 * glm::radians(56.0)), right = up * 16 / 9;
        return at.z < -0.2 && std::abs(at.x) < share * right * -at.z && std::abs(at.y) < share * up * -at.z;
    }

  private:
    dmat4 to_camera_;
};

class Spawns : public testing::TestWithParam<scene_generator::NamedScene> {
  protected:
    Spawns() {
        game.steps(60);
        game.session.app().show();
    }

    // Those that are in the picture with nothing before them.
    template <class Component>
    int in_sight() {
        const dmat4 camera = game.world().get<WorldTransform>(game.world().resource<View>().camera).matrix;
        const physics::Physics& physics = *game.world().resource<std::shared_ptr<physics::Physics>>();
        int found = 0;
        for (const ecs::Entity e : game.world().query<ecs::With<Component>>().entities()) {
            const dmat4& at = game.world().get<WorldTransform>(e).matrix;
            // A follower's place is its feet: half of its height is its middle.
            const dvec3 up(0, std::is_same_v<Component, Follower> ? 0.45 : 0, 0);
            const dvec3 place = physics.centre(e).value_or(dvec3(at[3])) + up, way = place - dvec3(camera[3]);
            // Its own body may be as wide as a screen.
            constexpr double kOwn = 0.5;
            const auto hit =
                physics.cast_ray(dvec3(camera[3]), way, glm::length(way) - kOwn, game.named("player"));
            found += Picture(camera).shows(place, 0.95) && (!hit || hit->entity == e) ? 1 : 0;
        }
        return found;
    }

    Played game{GetParam().make()};
};

TEST_P(Spawns, ShowHerAndWhatToDo) {
    constexpr double kFar = 2;  // metres: she is two thirds of the picture high
    const dmat4 camera = game.world().get<WorldTransform>(game.world().resource<View>().camera).matrix;
    const dvec3 eyes(
        game.world().get<WorldTransform>(game.world().query<ecs::With<Eyes>>().entities().front()).matrix[3]);
    const double away = glm::distance(dvec3(camera[3]), eyes);
    EXPECT_EQ(shown_from(away), 1);
    EXPECT_GE(away, kFar);
    EXPECT_TRUE(Picture(camera).shows(eyes, 0.95));
    // The red wall's crystal is behind the stones: the red wall itself is what is seen of it.
    EXPECT_GE(in_sight<Crystal>(), GetParam().name == "levels/red-wall" ? 0 : 1);
    EXPECT_GE(in_sight<Lantern>() + in_sight<Shutter>() + in_sight<Pushed>() + in_sight<Turntable>() +
                  in_sight<Follower>(),
              1);
}

INSTANTIATE_TEST_SUITE_P(Levels, Spawns, testing::ValuesIn(scene_generator::level_scenes()),
                         support::scene_name);

}  // namespace
}  // namespace lanthorn::game
