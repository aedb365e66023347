// Direct light of many lamps: groups of them (lamp_tree.h) against the sum over every one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace many_lamps_test {

using testing::SceneBuilder;

constexpr ivec2 kSize(48, 36);

// Uniform in [0, 1) (Steele et al. 2014).
double number(std::uint64_t counter) {
    std::uint64_t z = (counter + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

float between(std::uint64_t counter, float low, float high) {
    return low + (high - low) * static_cast<float>(number(counter));
}

// A ground of 24 x 24 metres, a wall at its far end and a box on it, seen from its near end.
SceneBuilder ground(const vec3& origin = vec3(0), bool things = true) {
    SceneBuilder b;
    const std::uint32_t white = b.add_lambert(vec3(0.8f));
    b.add_quad(white, origin, vec3(0, 0, 12), vec3(12, 0, 0));
    if (things) {
        b.add_quad(white, origin + vec3(0, 3, -12), vec3(12, 0, 0), vec3(0, 3, 0));
        b.add_box(white, origin + vec3(1, 0.6f, 2), vec3(0.8f, 0.6f, 0.7f), 0.4f);
    }
    b.look(origin + vec3(0, 3, 11), origin + vec3(0, 0.5f, 0), 0.9f);
    return b;
}

// Lamps over the ground, no two alike.
void add_points(SceneBuilder& b, int count, const vec3& origin = vec3(0)) {
    for (int i = 0; i < count; ++i) {
        const std::uint64_t k = 8 * static_cast<std::uint64_t>(i);
        b.add_point(origin + vec3(between(k, -11, 11), between(k + 1, 1.5f, 5), between(k + 2, -11, 11)),
                    between(k + 3, 0.2f, 2));
    }
}

struct Pictures {
    ImageF groups, all;
    std::uint32_t nan_count = 0;
};

Pictures pictures_of(const SceneBuilder& b, float error = 1e-3f) {
    testing::context();
    Pictures p;
    for (const bool groups : {true, false}) {
        render::FrameRenderer renderer;
        renderer.settings.shadow_resolution = 64;
        renderer.settings.lamps_error = groups ? error : 0;
        testing::render_once(renderer, b.build(), kSize);
        (groups ? p.groups : p.all) = renderer.read(render::Aov::direct);
        p.nan_count += renderer.nan_count();
    }
    return p;
}

struct Difference {
    double mean = 0;     // of |groups - all| over mean(all)
    double largest = 0;  // of |groups - all| / all, where that is not below a hundredth of the mean
    double share = 0;    // sum(groups) / sum(all)
};

Difference difference(const Pictures& p) {
    Difference d;
    double sum = 0, groups = 0;
    for (std::size_t i = 0; i < p.all.pixels.size(); ++i) {
        sum += static_cast<double>(p.all.pixels[i]);
        groups += static_cast<double>(p.groups.pixels[i]);
    }
    const double mean = sum / static_cast<double>(p.all.pixels.size());
    for (std::size_t i = 0; i < p.all.pixels.size(); ++i) {
        const auto all = static_cast<double>(p.all.pixels[i]);
        const double off = std::abs(static_cast<double>(p.groups.pixels[i]) - all);
        d.mean += off / mean / static_cast<double>(p.all.pixels.size());
        if (all > 0.01 * mean) {
            d.largest = std::max(d.largest, off / all);
        }
    }
    d.share = groups / sum;
    return d;
}

// Without anything that shades: the setting bounds the mean; a group's third moments, which it leaves out,
// are of no sign, and the pixel that has most of them is off by some five times as much.
TEST(ManyLamps, InTheOpenAreAsBrightAsTheSettingSays) {
    SceneBuilder b = ground(vec3(0), false);
    add_points(b, 160);
    const Pictures p = pictures_of(b);
    const Difference d = difference(p);
    EXPECT_NE(p.groups.pixels, p.all.pixels);
    EXPECT_LT(d.mean, 1e-3);
    EXPECT_LT(d.largest, 1e-2);
    EXPECT_NEAR(d.share, 1, 5e-4);
}

TEST(ManyLamps, BehindThingsAreWithinAHundredth) {
    SceneBuilder b = ground();
    add_points(b, 160);
    const Difference d = difference(pictures_of(b));
    EXPECT_LT(d.mean, 0.01);
    EXPECT_NEAR(d.share, 1, 1e-3);
}

// A finer setting is nearer to the sum.
TEST(ManyLamps, ComeNearerWithTheSetting) {
    SceneBuilder b = ground();
    add_points(b, 160);
    const double coarse = difference(pictures_of(b, 0.05f)).mean;
    const double fine = difference(pictures_of(b, 1e-5f)).mean;
    EXPECT_LT(fine, 0.5 * coarse);
}

// So few are added up one by one, whatever the setting.
TEST(ManyLamps, ThatAreFewAreAddedUpAsEver) {
    SceneBuilder b = ground();
    add_points(b, 128);
    const Pictures p = pictures_of(b);
    EXPECT_EQ(p.groups.pixels, p.all.pixels);
}

TEST(ManyLamps, OfShortRangeAreLeftOutWhereTheyDoNotReach) {
    SceneBuilder b = ground();
    add_points(b, 400);
    for (std::size_t i = 0; i < b.scene.lights.size(); ++i) {
        b.scene.lights[i].light.range = i % 7 == 0 ? 0 : between(i, 0.5f, 6);
    }
    const Difference d = difference(pictures_of(b));
    EXPECT_LT(d.largest, 1e-2);
}

TEST(ManyLamps, SpotsAreAllThere) {
    SceneBuilder b = ground();
    for (int i = 0; i < 900; ++i) {
        const std::uint64_t k = 8 * static_cast<std::uint64_t>(i);
        // Down, up, sideways and away from everything; wide ones, too.
        const vec3 direction =
            glm::normalize(vec3(between(k + 3, -1, 1), between(k + 4, -1, 0.5f), between(k + 5, -1, 1)));
        const float outer = between(k + 6, 0.1f, i % 5 == 0 ? 1.5f : 0.9f);
        b.add_spot(vec3(between(k, -11, 11), between(k + 1, 1, 5), between(k + 2, -11, 11)), direction,
                   between(k + 7, 1, 5), 0.5f * outer, outer);
        if (i % 3 == 0) {
            b.scene.lights.back().light.range = 4;
        }
    }
    const Pictures p = pictures_of(b);
    const Difference d = difference(p);
    EXPECT_LT(d.largest, 1e-4);
}

TEST(ManyLamps, AtOnePlaceAreOne) {
    SceneBuilder b = ground();
    for (int i = 0; i < 10'000; ++i) {
        b.add_point(vec3(2, 4, 3), 0.01f);
    }
    const ImageF groups = pictures_of(b).groups;
    SceneBuilder one = ground();
    one.add_point(vec3(2, 4, 3), 100);
    const Difference d = difference({groups, pictures_of(one).all});
    EXPECT_LT(d.mean, 2e-3);
    EXPECT_NEAR(d.share, 1, 1e-3);
}

TEST(ManyLamps, FarFromTheOriginAreAsAtIt) {
    const vec3 far(100'000, 0, -80'000);
    SceneBuilder here = ground(), there = ground();
    add_points(here, 160);
    there = here;
    // Render space has its origin near the camera: what is far is the origin.
    there.scene.origin = dvec3(far);
    EXPECT_EQ(pictures_of(here).groups.pixels, pictures_of(there).groups.pixels);
}

TEST(ManyLamps, BehindTheCameraAndAroundItLightWhatIsSeen) {
    SceneBuilder b = ground();
    for (int i = 0; i < 160; ++i) {
        const std::uint64_t k = 8 * static_cast<std::uint64_t>(i);
        // Around the camera at (0, 3, 11), half of them behind it.
        b.add_point(vec3(between(k, -1, 1), between(k + 1, 2, 4), between(k + 2, 10, 12)), 1);
    }
    const Difference d = difference(pictures_of(b));
    EXPECT_LT(d.mean, 0.01);
    EXPECT_NEAR(d.share, 1, 2e-3);
}

// Lamps within a millimetre of walls, in their planes and behind them. A group has the shadow of its middle
// lamp: one that straddles the ground shines from above it or not at all.
TEST(ManyLamps, InSurfacesAreFinite) {
    SceneBuilder b = ground();
    for (int i = 0; i < 160; ++i) {
        const std::uint64_t k = 8 * static_cast<std::uint64_t>(i);
        const float height = i % 3 == 0 ? 0.0f : i % 3 == 1 ? 1e-3f : -1e-3f;
        b.add_point(vec3(between(k, -11, 11), height, between(k + 2, -11, 11)), 1e-3f);
    }
    const Pictures p = pictures_of(b);
    EXPECT_EQ(p.nan_count, 0u);
    EXPECT_TRUE(std::ranges::all_of(p.groups.pixels, [](float v) { return std::isfinite(v) && v >= 0; }));
    EXPECT_NEAR(difference(p).share, 1, 0.2);
}

// A lamp that is no number is left out, and takes no other with it.
TEST(ManyLamps, ThatAreNoNumbersGiveNoLight) {
    SceneBuilder b = ground();
    add_points(b, 160);
    const ImageF without = pictures_of(b).groups;
    b.add_point(vec3(NAN, 1, 0), 1);
    b.add_point(vec3(0, 1, 0), NAN);
    b.add_point(vec3(std::numeric_limits<float>::infinity(), 1, 0), 1);
    render::FrameRenderer renderer;
    renderer.settings.shadow_resolution = 64;
    testing::render_once(renderer, b.build(), kSize);
    const Difference d = difference({renderer.read(render::Aov::direct), without});
    EXPECT_EQ(renderer.nan_count(), 0u);
    EXPECT_LT(d.largest, 1e-4);
}

// Beside area samples, a sun, spots and lamps that are off.
TEST(ManyLamps, MixWithOtherLights) {
    SceneBuilder b = testing::small_room(8, true);
    for (int i = 0; i < 300; ++i) {
        const std::uint64_t k = 8 * static_cast<std::uint64_t>(i);
        const vec3 place(between(k, -3, 3), between(k + 1, 0.5f, 6), between(k + 2, -3, 3));
        if (i % 3 == 0) {
            b.add_spot(place, vec3(0, -1, 0), 3, 0.2f, 0.8f);
        } else {
            b.add_point(place, i % 3 == 1 ? 1.0f : 0.0f);
        }
    }
    b.add_directional(vec3(0.2f, -1, 0.3f), 4);
    const Pictures p = pictures_of(b);
    EXPECT_EQ(p.nan_count, 0u);
    const Difference d = difference(p);
    EXPECT_LT(d.mean, 0.03);  // shadows, of groups among blocks
    EXPECT_NEAR(d.share, 1, 3e-3);
}

// More lamps than maps: bright and lonely ones have their own, and a wall still shades what lies behind it.
TEST(ManyLamps, ShareMapsAndAreShaded) {
    SceneBuilder b;
    const std::uint32_t white = b.add_lambert(vec3(0.8f));
    b.add_quad(white, vec3(0), vec3(0, 0, 12), vec3(12, 0, 0));
    b.add_quad(white, vec3(0, 3, 0), vec3(0, 3, 0), vec3(0, 0, 12));  // across the middle, x = 0
    b.look(vec3(6, 6, 11), vec3(6, 0, 0), 0.9f);
    for (int i = 0; i < 400; ++i) {  // on the other side
        const std::uint64_t k = 8 * static_cast<std::uint64_t>(i);
        b.add_point(vec3(between(k, -11, -2), between(k + 1, 1, 4), between(k + 2, -11, 11)), 1);
    }
    const Pictures dark = pictures_of(b);
    SceneBuilder open = b;
    open.scene.instances.pop_back();
    const Pictures lit = pictures_of(open);
    const auto mean = [](const ImageF& image) {
        double sum = 0;
        for (const float v : image.pixels) {
            sum += static_cast<double>(v);
        }
        return sum / static_cast<double>(image.pixels.size());
    };
    EXPECT_LT(mean(dark.groups), 0.02 * mean(lit.groups));
    EXPECT_LT(mean(dark.all), 0.02 * mean(lit.all));
}

// The same lamps seen from elsewhere: what is seen of a place does not depend on the camera, so that nothing
// flickers.
TEST(ManyLamps, DoNotFlickerAsTheCameraTurns) {
    SceneBuilder b = ground();
    add_points(b, 160);
    testing::context();
    render::FrameRenderer renderer;
    renderer.settings.shadow_resolution = 64;
    testing::render_once(renderer, b.build(), kSize);
    const ImageF first = renderer.read(render::Aov::direct);
    FrameScene scene = b.build();
    scene.changes = {};
    scene.frame = 1;
    testing::render_once(renderer, scene, kSize);
    EXPECT_EQ(renderer.read(render::Aov::direct).pixels, first.pixels);
}

}  // namespace many_lamps_test
}  // namespace lanthorn
