// What looks otherwise than it is: it fades by whole pixels, shines along its outline, and neither light nor
// exposure knows of it.
#include <gtest/gtest.h>

#include <memory>

#include "engine/render/scene_renderer.h"
#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace looks_test {

constexpr ivec2 kSize(64, 64);
constexpr float kWall = 4;

struct Pictures {
    ImageF final, radiance, depth;
    float exposure = 0;
};

// Looks from 0 along -Z at a dark ball of 0.5 m, 2 m away, before a grey wall that a lamp beside it lights.
class Ball {
  public:
    Ball() {
        b_.add_quad(b_.add_lambert(vec3(0.6f)), vec3(0, 0, -kWall), vec3(30, 0, 0), vec3(0, 30, 0));
        b_.add_sphere(b_.add_lambert(vec3(0.04f)), vec3(0, 0, -2), 0.5f);
        b_.add_point({0.9f, 0.6f, -2.6f}, 40);
        b_.look(vec3(0), vec3(0, 0, -1), 0.9f);
        ball = b_.scene.instances.back().id;
    }
    Pictures show(const render::Looks& looks, float rim = 0) const {
        testing::context();
        const auto shared = std::make_shared<render::SceneRenderer>();
        shared->show(looks);
        render::FrameRenderer renderer(shared);
        renderer.settings.rim = rim;
        testing::render_once(renderer, b_.build(), kSize);
        return {renderer.read(render::Aov::final), renderer.read(render::Aov::radiance),
                renderer.read(render::Aov::depth), renderer.exposure()};
    }
    std::uint32_t ball = 0;

  private:
    testing::SceneBuilder b_;
};

std::size_t at(int x, int y) {
    return static_cast<std::size_t>(y) * kSize.x + static_cast<std::size_t>(x);
}

TEST(Looks, OfNothingLeaveThePictureAsItIs) {
    const Ball scene;
    const Pictures plain = scene.show({}), whole = scene.show({{{scene.ball, 1, false}}}, 0.3f);
    EXPECT_EQ(plain.final.pixels, whole.final.pixels);
    EXPECT_EQ(plain.radiance.pixels, whole.radiance.pixels);
    const Pictures other = scene.show({{{scene.ball + 77, 0.1f, true}}}, 0.3f);
    EXPECT_EQ(plain.final.pixels, other.final.pixels);
}

// Where the ball is, so many pixels show it, and the others the wall, with the ball's shadow on it.
TEST(Looks, FadeByWholePixelsAndLeaveLightAlone) {
    const Ball scene;
    const Pictures plain = scene.show({});
    const Pictures gone = scene.show({{{scene.ball, 0, false}}});
    for (const float shown : {0.25f, 0.5f, 0.75f}) {
        const Pictures faded = scene.show({{{scene.ball, shown, false}}});
        int covered = 0, seen = 0;
        for (std::size_t i = 0; i < plain.depth.pixels.size(); ++i) {
            const bool ball = plain.depth.pixels[i] < 3;
            const bool here = faded.depth.pixels[i] < 3;
            covered += ball ? 1 : 0;
            seen += here ? 1 : 0;
            ASSERT_TRUE(ball || !here) << i;
            const Pictures& same = here ? plain : gone;
            for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
                ASSERT_EQ(faded.radiance.pixels[c], same.radiance.pixels[c]) << i;
            }
        }
        ASSERT_GT(covered, 500);
        EXPECT_NEAR(static_cast<float>(seen) / static_cast<float>(covered), shown, 0.04f);
    }
    // The wall in its shadow is darker than beside it.
    EXPECT_LT(gone.radiance.pixels[3 * at(10, 42)], 0.2f * gone.radiance.pixels[3 * at(50, 20)]);
}

TEST(Looks, RimsShineInThePictureAloneAndAlongTheOutline) {
    const Ball scene;
    const render::Looks rim{{{scene.ball, 1, true}}};
    const Pictures plain = scene.show({}), without = scene.show(rim), with = scene.show(rim, 0.15f);
    EXPECT_EQ(plain.final.pixels, without.final.pixels);
    EXPECT_EQ(plain.radiance.pixels, with.radiance.pixels);
    EXPECT_EQ(plain.exposure, with.exposure);
    float inside = 0, outline = 0;
    for (int x = 0; x < kSize.x; ++x) {
        const std::size_t i = at(x, 32);
        const float more = with.final.pixels[3 * i] - plain.final.pixels[3 * i];
        if (plain.depth.pixels[i] > 3) {
            EXPECT_EQ(more, 0) << x;
        } else if (plain.depth.pixels[i] < 1.52f) {
            inside = std::max(inside, more);
        } else {
            EXPECT_GE(more, 0) << x;
            outline = std::max(outline, more);
        }
    }
    EXPECT_LT(inside, 0.05f);
    EXPECT_GT(outline, 0.15f);
}

}  // namespace looks_test
}  // namespace lanthorn
