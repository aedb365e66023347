// Direct light on a white plane against closed forms, at three scales.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/gpu/render/scenes.h"
#include "tests/support/closed_forms.h"

namespace lanthorn {
namespace {

using testing::SceneBuilder;

constexpr ivec2 kSize(128, 128);
constexpr float kFov = 0.7f;

// The floor y = 0 seen from straight above at height 3 * scale; 2 x 2 units big.
SceneBuilder floor_scene(float scale) {
    SceneBuilder b;
    b.add_quad(b.add_lambert(vec3(1)), vec3(0), scale * vec3(0, 0, 1), scale * vec3(1, 0, 0));
    b.look(scale * vec3(0, 3, 0), vec3(0), kFov);
    return b;
}

// Where the pixel's ray meets the floor.
vec3 floor_point(int x, int y, float scale) {
    const float half = 3 * scale * std::tan(0.5f * kFov);
    const vec2 p((static_cast<float>(x) + 0.5f) / static_cast<float>(kSize.x) * 2 - 1,
                 1 - (static_cast<float>(y) + 0.5f) / static_cast<float>(kSize.y) * 2);
    return {p.x * half, 0, -p.y * half};  // up in the image is -Z
}

struct Errors {
    double mean = 0;  // of |error| / expected
    double largest = 0;
    double bias = 0;
    int pixels = 0;
};

// Irradiance pi * L of every floor pixel against `expected`(point); where that is NaN the pixel is left out.
Errors compare(const ImageF& direct, float scale, const std::function<float(vec3)>& expected) {
    Errors e;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const vec3 p = floor_point(x, y, scale);
            const float want = expected(p);
            if (std::max(std::abs(p.x), std::abs(p.z)) > 0.99f * scale || std::isnan(want) || want <= 0) {
                continue;
            }
            const std::size_t i = static_cast<std::size_t>(y * kSize.x + x) * 3;
            const double error = static_cast<double>(direct.pixels[i] * kPi / want) - 1;
            e.mean += std::abs(error);
            e.bias += error;
            e.largest = std::max(e.largest, std::abs(error));
            ++e.pixels;
        }
    }
    e.mean /= std::max(e.pixels, 1);
    e.bias /= std::max(e.pixels, 1);
    return e;
}

ImageF direct_of(const SceneBuilder& b, const render::RenderSettings& settings = {}) {
    testing::context();
    render::FrameRenderer renderer;
    renderer.settings = settings;
    testing::render_once(renderer, b.build(), kSize);
    return renderer.read(render::Aov::direct);
}

class DirectLight : public ::testing::TestWithParam<float> {};

TEST_P(DirectLight, PointFallsOffWithTheSquare) {
    const float s = GetParam();
    SceneBuilder b = floor_scene(s);
    const vec3 light = s * vec3(0.3f, 0.8f, -0.2f);
    b.add_point(light, 50);
    const Errors e = compare(direct_of(b), s, [&](vec3 p) {
        const vec3 d = light - p;
        const float r = glm::length(d);
        return 50 * d.y / (r * r * r);
    });
    EXPECT_GT(e.pixels, 8000);
    EXPECT_LT(e.largest, 0.01);
}

TEST_P(DirectLight, PointIsCutOffAtItsRange) {
    const float s = GetParam();
    SceneBuilder b = floor_scene(s);
    const vec3 light = s * vec3(0, 0.5f, 0);
    b.add_point(light, 50);
    b.scene.lights.back().light.range = 0.9f * s;
    const Errors e = compare(direct_of(b), s, [&](vec3 p) {
        const vec3 d = light - p;
        const float r = glm::length(d);
        const float window = std::clamp(1 - std::pow(r / (0.9f * s), 4.0f), 0.0f, 1.0f);
        return window > 0.01f ? window * 50 * d.y / (r * r * r) : NAN;
    });
    EXPECT_GT(e.pixels, 1000);
    EXPECT_LT(e.largest, 0.01);
}

void check_spot(float s, float inner, float outer) {
    SceneBuilder b = floor_scene(s);
    const vec3 light = s * vec3(-0.3f, 0.9f, 0.1f);
    const vec3 direction = glm::normalize(vec3(0.3f, -1, 0.1f));
    b.add_spot(light, direction, 20, inner, outer);
    const ImageF image = direct_of(b);
    const Errors e = compare(image, s, [&](vec3 p) {
        const vec3 d = light - p;
        const float r = glm::length(d);
        const float cosine = glm::dot(-d / r, direction);
        float a = (cosine - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
        a = std::clamp(a, 0.0f, 1.0f);
        return a > 0.05f ? a * a * 20 * d.y / (r * r * r) : NAN;
    });
    EXPECT_GT(e.pixels, 1000);
    EXPECT_LT(e.largest, 0.01);
}

TEST_P(DirectLight, NarrowSpotHasItsCone) {
    check_spot(GetParam(), 0.2f, 0.5f);
}
TEST_P(DirectLight, WideSpotHasItsCone) {
    check_spot(GetParam(), 0.9f, 1.3f);
}

TEST_P(DirectLight, DirectionalIsTheSameEverywhere) {
    const float s = GetParam();
    SceneBuilder b = floor_scene(s);
    const vec3 direction = glm::normalize(vec3(0.5f, -1, 0.2f));
    b.add_directional(direction, 1000);
    const Errors e = compare(direct_of(b), s, [&](vec3) { return -direction.y * 1000; });
    EXPECT_GT(e.pixels, 8000);
    EXPECT_LT(e.largest, 0.01);
}

void check_area(float s, int samples, float tolerance) {
    SceneBuilder b = floor_scene(s);
    Material lamp;
    lamp.emissive = vec3(100);
    const vec3 centre = s * vec3(0.1f, 0.7f, 0);
    const vec3 u = s * vec3(0.2f, 0, 0);
    const vec3 v = s * vec3(0, 0, 0.2f);
    b.add_quad(b.add_material(lamp), centre, u, v);  // faces down
    // The lamp hides the middle of the floor from above: look from below it instead.
    b.look(s * vec3(0, 0.6f, 0), vec3(0), 2.0f);
    render::RenderSettings settings;
    settings.area_lights_samples = samples;
    const ImageF image = direct_of(b, settings);
    const std::array<dvec3, 4> corners{centre - u - v, centre + u - v, centre + u + v, centre - u + v};
    double error = 0;
    double total = 0;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const float half = 0.6f * s * std::tan(1.0f);
            const vec3 p(((static_cast<float>(x) + 0.5f) / static_cast<float>(kSize.x) * 2 - 1) * half, 0,
                         ((static_cast<float>(y) + 0.5f) / static_cast<float>(kSize.y) * 2 - 1) * half);
            if (std::max(std::abs(p.x), std::abs(p.z)) > 0.95f * s) {
                continue;
            }
            const double want = 100 * support::kPiD * support::polygon_factor(corners, p, dvec3(0, 1, 0));
            const float got = image.pixels[static_cast<std::size_t>(y * kSize.x + x) * 3] * kPi;
            error += std::abs(static_cast<double>(got) - want);
            total += want;
        }
    }
    EXPECT_LT(error / total, static_cast<double>(tolerance));
}

TEST_P(DirectLight, EmissiveQuadFollowsLambertsPolygonFormula) {
    check_area(GetParam(), 4, 0.03f);
}
TEST_P(DirectLight, EmissiveQuadWithManySamplesIsCloser) {
    check_area(GetParam(), 16, 0.01f);
}

INSTANTIATE_TEST_SUITE_P(Scales, DirectLight, ::testing::Values(1e-3f, 1.0f, 1e3f));

// E / expected at the origin of a floor, under or beside a lamp of 100 nits centre +- u +- v; `expected` is a
// configuration factor.
double area_light_ratio(const vec3& centre, const vec3& u, const vec3& v, int samples, double expected) {
    SceneBuilder b;
    b.add_quad(b.add_lambert(vec3(1)), vec3(0), vec3(0, 0, 20), vec3(20, 0, 0));
    Material lamp;
    lamp.emissive = vec3(100);
    b.add_quad(b.add_material(lamp), centre, u, v);
    b.look_orthographic(vec3(0, 0.01f, 0.01f), vec3(0), 1e-4f, 1e-4f);
    render::RenderSettings settings;
    settings.area_lights_samples = samples;
    const ImageF image = direct_of(b, settings);
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
        sum += static_cast<double>(image.pixels[i]);
    }
    return 3 * sum / static_cast<double>(image.pixels.size()) / (100 * expected);
}

// A rectangle of 3 m x 1 m above a point, and one of 1.5 m x 2 m that stands on the floor 0.75 m from it
// (Howell, B-3 and B-4): the nearer, the more points must stand for it.
TEST(AreaLight, RectanglesByTheirConfigurationFactors) {
    struct Case {
        int samples;
        double parallel;
        double perpendicular;
    };
    for (const auto& [samples, parallel, perpendicular] : {Case{4, 0.055, 0.135}, Case{16, 0.05, 0.015}}) {
        for (const float h : {5.0f, 2.0f, 1.0f}) {
            const double ratio =
                area_light_ratio(vec3(0, h, 0), vec3(1.5f, 0, 0), vec3(0, 0, 0.5f), samples,
                                 4 * support::parallel_corner(1.5, 0.5, static_cast<double>(h)));
            EXPECT_NEAR(ratio, 1, parallel) << samples << " points, " << h << " m away";
        }
        const double ratio = area_light_ratio(vec3(0.75f, 1, -0.75f), vec3(0.75f, 0, 0), vec3(0, 1, 0),
                                              samples, support::perpendicular_corner(2, 1.5, 0.75));
        EXPECT_NEAR(ratio, 1, perpendicular) << samples << " points, at right angles";
    }
}

// More lights than a uniform block holds, and more maps than fit at full size: coarser maps, the same sum.
TEST(ManyLights, AddUp) {
    SceneBuilder b = floor_scene(1);
    constexpr int kSide = 12;
    for (int i = 0; i < kSide * kSide; ++i) {
        b.add_point(vec3(static_cast<float>(i % kSide) / 6 - 1, 0.8f, static_cast<float>(i / kSide) / 6 - 1),
                    1);
    }
    const auto& lights = b.scene.lights;
    const Errors e = compare(direct_of(b), 1, [&](vec3 p) {
        float sum = 0;
        for (const LightInstance& light : lights) {
            const vec3 d = light.position - p;
            sum += d.y / std::pow(glm::length(d), 3.0f);
        }
        return sum;
    });
    EXPECT_GT(e.pixels, 8000);
    EXPECT_LT(e.largest, 0.01);
}

// Shading adds lights up by kind, and leaves out those that shine not (shining_lights.h).
TEST(ManyLights, OfEveryKindAddUpInAnyOrder) {
    SceneBuilder b = floor_scene(1);
    b.add_spot(vec3(-0.3f, 0.9f, 0.3f), vec3(0, -1, 0), 3, 0.2f, 0.4f);
    b.add_point(vec3(0.4f, 0.7f, 0.1f), 0);
    b.add_spot(vec3(0.2f, 0.6f, -0.4f), vec3(0, -1, 0), 2, 0.9f, 1.3f);  // wide: its map is a cube
    b.add_directional(vec3(0.2f, -1, 0.1f), 0);                          // of its kind the only one
    b.add_point(vec3(-0.5f, 0.8f, -0.2f), 1);
    b.add_quad(b.add_lambert(vec3(0)), vec3(0, 0.3f, 0), vec3(0, 0, 0.1f), vec3(0.1f, 0, 0));  // shades
    const std::vector<LightInstance> all = b.scene.lights;
    testing::context();
    render::FrameRenderer renderer;
    testing::render_once(renderer, b.build(), kSize);
    const ImageF together = renderer.read(render::Aov::direct);
    std::vector<double> sum(together.pixels.size(), 0);
    for (const LightInstance& light : all) {
        b.scene.lights = {light};
        const ImageF alone = direct_of(b);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += static_cast<double>(alone.pixels[i]);
        }
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
        ASSERT_NEAR(static_cast<double>(together.pixels[i]), sum[i], 1e-5 * sum[i] + 1e-7) << i;
    }

    // The dark ones begin to shine, and two of the others end.
    b.scene.lights = all;
    b.scene.lights[1].light.intensity = 2;
    b.scene.lights[3].light.intensity = 4;
    b.scene.lights[0].light.intensity = b.scene.lights[4].light.intensity = 0;
    FrameScene scene = b.build();
    scene.changes.lights = true;
    testing::render_once(renderer, scene, kSize);
    EXPECT_EQ(renderer.read(render::Aov::direct).pixels, direct_of(b).pixels);
}

// Every light type at once, metallic and smooth material, unlit background: nothing but finite numbers.
TEST(DirectLightMix, EverythingIsFinite) {
    testing::context();
    SceneBuilder b = testing::small_room(1, true);
    Material mirror;
    mirror.roughness = 0;
    b.add_sphere(b.add_material(mirror), vec3(0, 0.8f, 0.2f), 0.1f);
    b.add_point(vec3(0.2f, 0.5f, 0.3f), 1);
    b.add_point(vec3(0, 0, 0), 1);  // in the floor's plane
    b.add_spot(vec3(-0.3f, 0.7f, 0.3f), vec3(0, -1, 0), 1, 0, 0.4f);
    b.add_directional(vec3(0, -1, -1), 10);
    render::FrameRenderer renderer;
    testing::render_once(renderer, b.build(), {200, 150});
    EXPECT_EQ(renderer.nan_count(), 0u);
    const auto image = renderer.read(render::Aov::radiance);
    EXPECT_TRUE(std::ranges::all_of(image.pixels, [](float v) { return std::isfinite(v) && v >= 0; }));
    testing::save_picture(renderer.read(render::Aov::final), "mix");
}

}  // namespace
}  // namespace lanthorn
