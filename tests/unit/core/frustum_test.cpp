// Boxes against frusta whose walls are known on paper.
#include "lanthorn/core/frustum.h"

#include <gtest/gtest.h>

#include <random>

namespace lanthorn {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Looks along -Z from `eye` with a right angle between opposite walls; near plane at 0.5, none far away.
Frustum quarter_turn(const vec3& eye = vec3(0)) {
    mat4 clip(0);
    clip[0][0] = clip[1][1] = 1;
    clip[2][3] = -1;
    clip[3][2] = 0.5f;
    return Frustum::of_clip(clip, eye);
}

Aabb box(const vec3& centre, float half) {
    return {centre - half, centre + half};
}

TEST(Frustum, SeesBoxesInsideAndOnItsWallsAndNoneOutside) {
    for (const vec3& eye : {vec3(0), vec3(100, -20, 7)}) {
        const Frustum frustum = quarter_turn(eye);
        const auto sees = [&](const vec3& centre, float half) {
            return frustum.touches(box(eye + centre, half));
        };
        EXPECT_TRUE(sees({0, 0, -10}, 1)) << "inside";
        EXPECT_TRUE(sees({0, 0, 0}, 5)) << "around the eye";
        EXPECT_TRUE(sees({0, 0, -5}, 100)) << "around the whole of what is near";
        for (const vec3& side : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0)}) {
            // A wall at 10 m is 10 m aside; a box of half 1 has its nearest corner at (x - 1) aside and 11 m
            // off.
            EXPECT_TRUE(sees(10.0f * side + vec3(0, 0, -10), 1)) << "straddling";
            EXPECT_TRUE(sees(11.9f * side + vec3(0, 0, -10), 1)) << "a corner reaches in";
            EXPECT_FALSE(sees(12.1f * side + vec3(0, 0, -10), 1)) << "aside";
        }
        EXPECT_FALSE(sees({0, 0, 10}, 1)) << "behind";
        EXPECT_FALSE(sees({0, 0, 0.7f}, 1)) << "before the near plane: its far end is at 0.3";
        EXPECT_TRUE(sees({0, 0, 0.4f}, 1)) << "its far end is at 0.6";
        EXPECT_TRUE(sees({0, 0, -1e30f}, 1)) << "no far plane";
    }
}

TEST(Frustum, OrthographicOnesEndAtBothPlanes) {
    mat4 clip(0);  // half width 2, half height 1, z from -1 to -5 to depth 1 to 0
    clip[0][0] = 0.5f;
    clip[1][1] = 1;
    clip[2][2] = 0.25f;
    clip[3][2] = 1.25f;
    clip[3][3] = 1;
    const Frustum frustum = Frustum::of_clip(clip, vec3(0));
    EXPECT_TRUE(frustum.touches(box({1.5f, 0.5f, -3}, 0.1f)));
    EXPECT_TRUE(frustum.touches(box({2.05f, 0, -3}, 0.1f)));
    EXPECT_FALSE(frustum.touches(box({2.15f, 0, -3}, 0.1f)));
    EXPECT_FALSE(frustum.touches(box({0, -1.15f, -3}, 0.1f)));
    EXPECT_TRUE(frustum.touches(box({0, 0, -5.05f}, 0.1f)));
    EXPECT_FALSE(frustum.touches(box({0, 0, -5.15f}, 0.1f)));
    EXPECT_FALSE(frustum.touches(box({0, 0, -0.85f}, 0.1f)));
}

TEST(Frustum, FacesOfACubeShareAllOfSpace) {
    const vec3 centre(3, -1, 2);
    const auto face = [&](int f) { return Frustum::of_cube_face(centre, f); };
    const Aabb ahead{centre + vec3(2, -0.1f, -0.1f), centre + vec3(3, 0.1f, 0.1f)};
    const Aabb on_edge{centre + vec3(1), centre + vec3(2)};
    for (int f = 0; f < 6; ++f) {
        EXPECT_EQ(face(f).touches(ahead), f == 0) << f;
        EXPECT_EQ(face(f).touches(on_edge), f % 2 == 0) << f;
        EXPECT_TRUE(face(f).touches(box(centre, 1))) << f;
        EXPECT_FALSE(face(f).touches(Aabb{})) << f;
    }
    std::mt19937 random(1);
    const auto number = [&] { return 2 * float(random()) / float(std::mt19937::max()) - 1; };
    for (int i = 0; i < 1000; ++i) {
        const vec3 d(number(), number(), number());
        const vec3 a = glm::abs(d);
        const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
        EXPECT_TRUE(face(2 * axis + (d[axis] < 0)).touches(box(centre + d, 0)));
        EXPECT_FALSE(face(2 * axis + (d[axis] > 0)).touches(box(centre + d, 0)));
    }
}

// Whatever point of a box is in the clip volume, the box is seen.
TEST(Frustum, NeverMissesABoxOfWhichAPointIsInside) {
    std::mt19937 random(2);
    const auto number = [&](float low, float high) {
        return low + (high - low) * float(random()) / float(std::mt19937::max());
    };
    int seen = 0, missed = 0;
    for (int i = 0; i < 20'000; ++i) {
        mat4 clip(0);
        clip[0][0] = number(0.3f, 3);
        clip[1][1] = number(0.3f, 3);
        clip[2][3] = -1;
        clip[3][2] = 0.01f;
        clip = clip * glm::mat4_cast(glm::angleAxis(number(-3, 3),
                                                    glm::normalize(vec3(number(-1, 1), 1, number(-1, 1)))));
        const vec3 eye(number(-50, 50), number(-50, 50), number(-50, 50));
        const vec3 half(number(0, 3), number(0, 3), number(0, 3));
        const vec3 centre = eye + vec3(number(-9, 9), number(-9, 9), number(-9, 9));
        const Aabb bounds{centre - half, centre + half};
        const bool touches = Frustum::of_clip(clip, eye).touches(bounds);
        for (int k = 0; k < 30; ++k) {
            const vec3 p = centre + half * vec3(number(-1, 1), number(-1, 1), number(-1, 1));
            const vec4 c = clip * vec4(p - eye, 1);
            const bool inside = std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && c.z >= 0 && c.z <= c.w;
            EXPECT_FALSE(inside && !touches) << i;
        }
        ++(touches ? seen : missed);
    }
    EXPECT_GT(seen, 1000);
    EXPECT_GT(missed, 1000);
}

TEST(Frustum, HugeAndBrokenBoundsAreNeverCulled) {
    const Frustum frustum = quarter_turn(vec3(-3e38f, 0, 0));
    const float most = std::numeric_limits<float>::max();
    EXPECT_TRUE(quarter_turn().touches({vec3(-most), vec3(most)}));
    EXPECT_TRUE(frustum.touches({vec3(-most), vec3(most)}));
    EXPECT_TRUE(quarter_turn().touches({vec3(-kInfinity), vec3(kInfinity)}));
    EXPECT_TRUE(quarter_turn().touches({vec3(kNan), vec3(kNan)}));
    EXPECT_TRUE(quarter_turn().touches({vec3(-1, kNan, -3), vec3(1, kNan, -2)}));
    EXPECT_TRUE(quarter_turn(vec3(kNan)).touches(box({0, 0, -3}, 1)));
    // Ahead, as far away as a float can tell: differences that no float holds.
    const Frustum leftwards = Frustum::of_cube_face(vec3(most, 0, 0), 1);
    EXPECT_TRUE(leftwards.touches({vec3(-most), vec3(-0.9f * most)}));
    EXPECT_FALSE(Frustum::of_cube_face(vec3(most, 0, 0), 4).touches({vec3(-most), vec3(-0.9f * most, 0, 0)}));
}

}  // namespace
}  // namespace lanthorn
