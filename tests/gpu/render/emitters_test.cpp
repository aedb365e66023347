// Emissive surfaces, any number of them and of any texture, light a room as their shape says.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "engine/render/area_samples.h"
#include "tests/gpu/render/scenes.h"
#include "tests/support/closed_forms.h"

namespace lanthorn {
namespace emitters_test {

// Sixteen panels of 40 cm in a ceiling of 8 m by 6 m, 3 m up.
constexpr int kAcross = 4, kAlong = 4;
constexpr float kHalf = 0.2f, kHeight = 3;

vec3 panel_centre(int i, int k) {
    return {(static_cast<float>(i) - 1.5f) * 2, kHeight, (static_cast<float>(k) - 1.5f) * 1.5f};
}

const vec3 kU(kHalf, 0, 0), kV(0, 0, kHalf);  // cross(u, v) looks down

Material glowing(const vec3& nits) {
    Material lamp;
    lamp.emissive = nits;
    return lamp;
}

FrameScene panels_as_meshes() {
    testing::SceneBuilder b;
    const std::uint32_t lamp = b.add_material(glowing(vec3(1000)));
    for (int i = 0; i < kAcross; ++i) {
        for (int k = 0; k < kAlong; ++k) {
            b.add_quad(lamp, panel_centre(i, k), kU, kV);
        }
    }
    return b.build();
}

FrameScene panels_as_a_mesh() {
    testing::SceneBuilder b;
    const std::uint32_t lamp = b.add_material(glowing(vec3(1000)));
    b.add_quad(lamp, panel_centre(0, 0), kU, kV);
    Mesh mesh = b.assets.meshes[0];
    const Mesh one = mesh;
    for (int n = 1; n < kAcross * kAlong; ++n) {
        const vec3 by = panel_centre(n / kAlong, n % kAlong) - panel_centre(0, 0);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (Vertex vertex : one.vertices) {
            vertex.position += by;
            mesh.vertices.push_back(vertex);
        }
        for (const std::uint32_t index : one.indices) {
            mesh.indices.push_back(first + index);
        }
    }
    b.assets.meshes.edit(0, [&](Mesh& m) { m = mesh; });
    return b.build();
}

enum class By { emission, alpha };

// The whole ceiling, of which a texture leaves the panels: texels of 20 cm by 5 cm. That of emission, or the
// alpha of what is blended, whose factor is 0.5.
FrameScene panels_as_a_texture(By by) {
    testing::SceneBuilder b;
    constexpr std::uint32_t kWidth = 40, kDepth = 120;
    Image image;
    image.width = kWidth;
    image.height = kDepth;
    image.rgba.assign(4 * kWidth * kDepth, 0);
    for (std::uint32_t y = 0; y < kDepth; ++y) {
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const vec2 at((static_cast<float>(x) + 0.5f) * 0.2f - 4,
                          (static_cast<float>(y) + 0.5f) * 0.05f - 3);
            for (int n = 0; n < kAcross * kAlong; ++n) {
                const vec3 c = panel_centre(n / kAlong, n % kAlong);
                if (std::abs(at.x - c.x) < kHalf && std::abs(at.y - c.z) < kHalf) {
                    for (std::uint32_t channel = 0; channel < 4; ++channel) {
                        image.rgba[4 * (y * kWidth + x) + channel] = 255;
                    }
                }
            }
        }
    }
    Sampler nearest;
    nearest.mag = Filter::nearest;
    Material lamp = glowing(vec3(by == By::alpha ? 2000 : 1000));
    if (by == By::alpha) {
        lamp.alpha_mode = AlphaMode::blend;
        lamp.base_colour.a = 0.5f;
    }
    TextureRef& texture = by == By::alpha ? lamp.base_colour_texture : lamp.emissive_texture;
    texture.texture = b.add_image(image, nearest);
    b.add_quad(b.add_material(lamp), vec3(0, kHeight, 0), vec3(4, 0, 0), vec3(0, 0, 3));
    return b.build();
}

std::vector<render::LightData> samples_of(const FrameScene& scene) {
    testing::context();
    render::EmissiveTriangles emissive;
    emissive.update(scene);
    return make_area_samples(emissive, render::RenderSettings()).lights;
}

struct Place {
    dvec3 at, normal;
};

std::vector<Place> floor_and_wall() {
    std::vector<Place> places;
    for (int x = 0; x < 8; ++x) {
        for (int z = 0; z < 6; ++z) {
            places.push_back({{x - 3.5, 0, z - 2.5}, {0, 1, 0}});
        }
        for (int y = 0; y < 5; ++y) {
            places.push_back({{x - 3.5, 0.25 + 0.5 * y, -3}, {0, 0, 1}});
        }
    }
    return places;
}

// Without shadow: the points' own formula, engine/render/lights.glsl.
double illuminance(const std::vector<render::LightData>& samples, const Place& place) {
    double sum = 0;
    for (const render::LightData& s : samples) {
        const dvec3 d = dvec3(s.position) - place.at;
        const double r2 = glm::dot(d, d);
        const dvec3 l = d / std::sqrt(r2);
        const double out = -glm::dot(l, dvec3(s.direction));
        const double area = static_cast<double>(s.area);
        sum += static_cast<double>(s.intensity.g) * std::max(0.0, glm::dot(place.normal, l)) * area *
               (s.two_sided != 0 ? std::abs(out) : std::max(0.0, out)) / (r2 + area / 3.14159265358979);
    }
    return sum;
}

double exact_illuminance(const Place& place) {
    double sum = 0;
    for (int n = 0; n < kAcross * kAlong; ++n) {
        const dvec3 c(panel_centre(n / kAlong, n % kAlong)), u(kU), v(kV);
        const std::array<dvec3, 4> corners{c - u - v, c + u - v, c + u + v, c - u + v};
        sum += 1000 * support::kPiD * support::polygon_factor(corners, place.at, place.normal);
    }
    return sum;
}

void expect_light_of_the_panels(const FrameScene& scene, const char* name) {
    const auto samples = samples_of(scene);
    double squares = 0, sum = 0, exact_sum = 0;
    const auto places = floor_and_wall();
    for (const Place& place : places) {
        const double exact = exact_illuminance(place), found = illuminance(samples, place);
        squares += (found - exact) * (found - exact);
        sum += found;
        exact_sum += exact;
    }
    const double n = static_cast<double>(places.size());
    const double error = std::sqrt(squares / n) / (exact_sum / n);
    std::printf("16 panels as %s: %zu points, relRMSE %.3f, flux %.3f\n", name, samples.size(), error,
                sum / exact_sum);
    EXPECT_LE(samples.size(), 16U);  // what they may cost
    EXPECT_LT(error, 0.05);
    EXPECT_NEAR(sum / exact_sum, 1, 0.02);
}

TEST(Emitters, SixteenPanelsAsMeshes) {
    expect_light_of_the_panels(panels_as_meshes(), "meshes");
}
TEST(Emitters, SixteenPanelsAsAMesh) {
    expect_light_of_the_panels(panels_as_a_mesh(), "a mesh");
}
TEST(Emitters, SixteenPanelsAsATexture) {
    expect_light_of_the_panels(panels_as_a_texture(By::emission), "a texture");
}
TEST(Emitters, SixteenPanelsAsAlpha) {
    expect_light_of_the_panels(panels_as_a_texture(By::alpha), "alpha");
}

// What is blended is as bright as it covers; without alpha it is no lamp, and when its alpha changes it is
// another one.
TEST(Emitters, BlendedOnesShineAsMuchAsTheyCover) {
    testing::context();
    testing::SceneBuilder b;
    Material lamp = glowing(vec3(1000));
    lamp.alpha_mode = AlphaMode::blend;
    lamp.base_colour.a = 0.25f;
    b.add_quad(b.add_material(lamp), vec3(0, kHeight, 0), kU, kV);
    FrameScene scene = b.build();
    render::EmissiveTriangles emissive;
    emissive.update(scene);
    EXPECT_EQ(emissive.count(), 2);
    EXPECT_NEAR(emissive.flux().g / (kPi * 250 * 4 * kHalf * kHalf), 1, 1e-5);
    SceneAssets assets = *scene.assets;
    assets.materials.edit(0, [](Material& m) { m.base_colour.a = 0; });
    assets.serial = next_asset_version();
    scene.assets = std::make_shared<const SceneAssets>(std::move(assets));
    ++scene.frame;
    scene.changes.geometry = true;
    emissive.update(scene);
    EXPECT_EQ(emissive.count(), 0);
    EXPECT_EQ(emissive.flux(), vec3(0));
    EXPECT_TRUE(make_area_samples(emissive, render::RenderSettings()).lights.empty());
}

// What glows, of a thousand lamps or of a mesh of a hundred thousand triangles: all of it, by 64 points at
// most.
TEST(Emitters, NoneIsLeftOut) {
    testing::SceneBuilder many;
    double flux = 0;
    for (int i = 0; i < 1000; ++i) {
        const float nits = 10.0f + static_cast<float>((i * 37) % 100);
        many.add_quad(many.add_material(glowing(vec3(nits))),
                      vec3(static_cast<float>(i % 40), 3, static_cast<float>(i / 40)), 0.1f * kU, 0.1f * kV);
        flux += static_cast<double>(nits) * 4 * 0.02 * 0.02;
    }
    const auto samples = samples_of(many.build());
    double found = 0;
    for (const render::LightData& s : samples) {
        found += static_cast<double>(s.intensity.g * s.area);
    }
    EXPECT_NEAR(found / flux, 1, 1e-3);
    EXPECT_LE(samples.size(), 64U);
    EXPECT_GT(samples.size(), 48U);
    EXPECT_EQ(samples.back().id, render::kMergedSurfaces);
}

// 1e9 nits beside 1e-3: both are there, and no number is lost.
TEST(Emitters, FaintOnesBesideBrightOnes) {
    testing::SceneBuilder b;
    b.add_quad(b.add_material(glowing(vec3(1e9f))), vec3(0, 3, 0), kU, kV);
    b.add_quad(b.add_material(glowing(vec3(1e-3f))), vec3(2, 3, 0), kU, kV);
    const auto samples = samples_of(b.build());
    ASSERT_EQ(samples.size(), 8U);
    for (const render::LightData& s : samples) {
        EXPECT_TRUE(s.intensity.g == 1e9f || s.intensity.g == 1e-3f);
        EXPECT_NEAR(s.area, 4 * 0.2f * 0.2f / 4, 1e-4f);
    }
}

}  // namespace emitters_test
}  // namespace lanthorn
