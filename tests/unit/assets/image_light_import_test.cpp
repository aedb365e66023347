// EXT_lights_image_based: cube images or coefficients become a sky, its rotation and its intensity.
#include <array>
#include <cmath>

#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;

const std::array<vec3, 6> kAxes = {vec3(1, 0, 0),  vec3(-1, 0, 0), vec3(0, 1, 0),
                                   vec3(0, -1, 0), vec3(0, 0, 1),  vec3(0, 0, -1)};

double luminous_flux(const SkyImage& image) {
    double flux = 0;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            flux += static_cast<double>(image.at(x, y).y) * image.pixel_solid_angle(y);
        }
    }
    return flux;
}

class ImageLightImport : public ImportTest {
  protected:
    void SetUp() override {
        builder.add_triangle();
        builder.json["scenes"] = {
            {{"nodes", {0}}, {"extensions", {{"EXT_lights_image_based", {{"light", 0}}}}}}};
        builder.json["extensions"]["EXT_lights_image_based"]["lights"] = {json::object()};
        builder.json["extensionsUsed"] = {"EXT_lights_image_based"};
    }
    json& light() { return builder.json["extensions"]["EXT_lights_image_based"]["lights"][0]; }
    json& scene_light() { return builder.json["scenes"][0]["extensions"]["EXT_lights_image_based"]["light"]; }

    // An image of the file; its index.
    int add_image(const std::string& bytes) {
        json& images = builder.json["images"];
        images.push_back({{"bufferView", builder.add_view(bytes)}, {"mimeType", "image/png"}});
        return static_cast<int>(images.size()) - 1;
    }
    // A face of 4 x 4 texels, each pixel(x, y) as RGBD.
    template <class Pixel>
    int add_face(const Pixel& pixel) {
        std::vector<std::uint8_t> texels;
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 4; ++x) {
                const std::array<std::uint8_t, 4> p = pixel(x, y);
                texels.insert(texels.end(), p.begin(), p.end());
            }
        }
        return add_image(make_png(4, 4, texels, 4));
    }
    // Faces of one colour each: (40 (f + 1), 255, 0), alpha as given.
    void add_cube(std::uint8_t alpha = 255) {
        json level = json::array();
        for (int f = 0; f < 6; ++f) {
            level.push_back(add_face([&](int, int) {
                return std::array<std::uint8_t, 4>{static_cast<std::uint8_t>(40 * (f + 1)), 255, 0, alpha};
            }));
        }
        light()["specularImages"] = {level};
        light()["specularImageSize"] = 4;
    }
    void add_even_coefficients(float lux) {
        json rows = json::array();
        for (int i = 0; i < 9; ++i) {
            const float value = i == 0 ? lux / 0.282095f : 0.0f;
            rows.push_back({value, value, value});
        }
        light()["irradianceCoefficients"] = rows;
    }
    // What the sky of the file sends from a direction of the scene.
    static vec3 radiance(const SceneData& scene, const vec3& direction) {
        for (const NodeData& node : scene.nodes) {
            if (node.sky != kNone) {
                const Sky& sky = scene.skies.at(node.sky);
                return sky_radiance(*sky.image, glm::inverse(node.local.rotation) * direction) *
                       (sky.colour * sky.intensity);
            }
        }
        ADD_FAILURE() << "no sky";
        return vec3(-1);
    }
};

TEST_F(ImageLightImport, EachFaceLiesTowardsItsAxis) {
    add_cube();
    light()["name"] = "studio";
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty()) << testing::PrintToString(scene.warnings);
    ASSERT_EQ(scene.skies.size(), 1u);
    EXPECT_EQ(scene.nodes.back().name, "studio");
    EXPECT_EQ(scene.skies[0].image->height, 8u);
    for (std::size_t f = 0; f < 6; ++f) {
        const float encoded = 40 * static_cast<float>(f + 1) / 255;
        const vec3 got = radiance(scene, kAxes[f]);
        EXPECT_NEAR(got.x, std::pow((encoded + 0.055f) / 1.055f, 2.4f), 0.02f) << f;
        EXPECT_NEAR(got.y, 1, 1e-4) << f;
        EXPECT_EQ(got.z, 0) << f;
    }
}

// What is seen from inside: on +X the right is +Z, on +Z it is -X; on +Y the top is -Z.
TEST_F(ImageLightImport, FacesAreSeenFromInside) {
    json level = json::array();
    for (int f = 0; f < 6; ++f) {
        level.push_back(add_face([&](int x, int y) {
            return std::array<std::uint8_t, 4>{static_cast<std::uint8_t>(x >= 2 ? 255 : 0),
                                               static_cast<std::uint8_t>(y >= 2 ? 255 : 0), 0, 255};
        }));
    }
    light()["specularImages"] = {level};
    const SceneData scene = import();
    const auto right = [&](const vec3& d) { return radiance(scene, glm::normalize(d)).x > 0.5f; };
    const auto below = [&](const vec3& d) { return radiance(scene, glm::normalize(d)).y > 0.5f; };
    EXPECT_TRUE(right({1, 0.2f, 0.6f}));
    EXPECT_FALSE(right({1, 0.2f, -0.6f}));
    EXPECT_TRUE(right({-0.6f, 0.2f, 1}));
    EXPECT_FALSE(right({0.6f, 0.2f, 1}));
    EXPECT_TRUE(right({-1, 0.2f, -0.6f}));
    EXPECT_TRUE(right({0.6f, 0.2f, -1}));
    EXPECT_TRUE(below({1, -0.6f, 0.2f}));
    EXPECT_FALSE(below({1, 0.6f, 0.2f}));
    EXPECT_TRUE(below({0.2f, 1, 0.6f}));
    EXPECT_FALSE(below({0.2f, 1, -0.6f}));
    EXPECT_TRUE(below({0.2f, -1, -0.6f}));
    EXPECT_TRUE(right({-0.6f, 1, 0.2f}));
    EXPECT_TRUE(right({-0.6f, -1, 0.2f}));
}

TEST_F(ImageLightImport, AlphaDividesAndIntensityMultiplies) {
    add_cube(51);
    light()["intensity"] = 3;
    EXPECT_NEAR(radiance(import(), vec3(0, 1, 0)).y, 15, 1e-3);
    light()["intensity"] = -1;
    const SceneData dark = import();
    expect_warning(dark, "/extensions/EXT_lights_image_based/lights/0/intensity", "is outside 0..");
    EXPECT_EQ(radiance(dark, vec3(0, 1, 0)), vec3(0));
}

TEST_F(ImageLightImport, RotationTurnsTheSky) {
    add_cube();
    light()["rotation"] = {0, 0, 0.70710678, 0.70710678};  // +X becomes +Y
    const SceneData scene = import();
    light().erase("rotation");
    const SceneData before = import();
    expect_near(radiance(scene, vec3(0, 1, 0)), radiance(before, vec3(1, 0, 0)), 1e-3f);
    light()["rotation"] = {0, 0, 0, 0};
    expect_warning(import(), "/extensions/EXT_lights_image_based/lights/0/rotation", "zero quaternion");
}

// The image keeps the cube's flux though its brightest texels are far smaller than a pixel near a corner.
TEST_F(ImageLightImport, TheFluxIsTheCubes) {
    json level = json::array();
    double wanted = 0;
    for (int f = 0; f < 6; ++f) {
        level.push_back(add_face([&](int x, int y) {
            const bool bright = x == 0 && y == f % 4;
            return std::array<std::uint8_t, 4>{255, 255, 255, static_cast<std::uint8_t>(bright ? 5 : 255)};
        }));
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 4; ++x) {
                // Of a texel, by the mean over 64 x 64 points.
                for (int k = 0; k < 4096; ++k) {
                    const double u = (x + (k % 64 + 0.5) / 64) / 2 - 1, v = (y + (k / 64 + 0.5) / 64) / 2 - 1;
                    wanted +=
                        (x == 0 && y == f % 4 ? 51 : 1) * 0.25 / 4096 * std::pow(1 + u * u + v * v, -1.5);
                }
            }
        }
    }
    light()["specularImages"] = {level};
    EXPECT_NEAR(luminous_flux(*import().skies.at(0).image) / wanted, 1, 1e-4);
}

// A bright spot of a fine cube is a sun of its own, as with images from files, and turns with the sky.
TEST_F(ImageLightImport, SunsBecomeLights) {
    json level = json::array();
    for (int f = 0; f < 6; ++f) {
        std::vector<std::uint8_t> texels(std::size_t{32} * 32 * 4, 255);
        if (f == 0) {
            texels[4 * (16 * 32 + 16) + 3] = 1;
        } else {
            for (std::size_t i = 0; i < texels.size(); ++i) {
                texels[i] = i % 4 == 3 ? 255 : 13;
            }
        }
        level.push_back(add_image(make_png(32, 32, texels, 4)));
    }
    light()["specularImages"] = {level};
    light()["rotation"] = {0, 0, 0.70710678, 0.70710678};
    const SceneData scene = import();
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].type, LightType::directional);
    const NodeData& sun = scene.nodes.back();
    ASSERT_NE(sun.parent, kNone);
    const vec3 shines = scene.nodes[sun.parent].local.rotation * (sun.local.rotation * vec3(0, 0, -1));
    EXPECT_GT(glm::dot(shines, vec3(0, -1, 0)), 0.99f) << "the face of +X has been turned to +Y";
}

// Irradiance 10 lux from everywhere is radiance 10 / pi; with a part along +Z it is more from there.
TEST_F(ImageLightImport, CoefficientsAloneAreASmoothSky) {
    add_even_coefficients(10);
    EXPECT_NEAR(radiance(import(), glm::normalize(vec3(1, 2, 3))).x, 10 / kPi, 1e-3);
    light()["irradianceCoefficients"][2] = {4, 4, 4};
    const SceneData scene = import();
    // E(n) = integral of L(w) max(n w, 0) dw at +Z is what the coefficients say.
    double lux = 0;
    const SkyImage& image = *scene.skies.at(0).image;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const vec3 d = sky_direction({(static_cast<float>(x) + 0.5f) / static_cast<float>(image.width),
                                          (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height)});
            lux += static_cast<double>(image.at(x, y).x * std::max(d.z, 0.0f)) * image.pixel_solid_angle(y);
        }
    }
    EXPECT_NEAR(lux, 10 + 4 * 0.488603, 0.05);
}

TEST_F(ImageLightImport, DamagedImagesLeaveTheCoefficients) {
    add_cube();
    add_even_coefficients(10);
    builder.json["images"][3] = {{"uri", "missing.png"}};
    SceneData scene = import();
    expect_warning(scene, "/images/3", "cannot be read; the environment's images are left out");
    EXPECT_NEAR(radiance(scene, vec3(0, 1, 0)).x, 10 / kPi, 1e-3);
    builder.json["images"][3] = {{"bufferView", builder.add_view("no image")}, {"mimeType", "image/png"}};
    expect_warning(import(), "/images/3", "is of no image format that is known");
    light().erase("irradianceCoefficients");
    scene = import();
    EXPECT_TRUE(scene.skies.empty());
    EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST_F(ImageLightImport, FacesOfOtherSizesAreTold) {
    add_cube();
    light()["specularImages"][0][2] = add_image(make_png(2, 4, std::vector<std::uint8_t>(32, 9), 4));
    const SceneData scene = import();
    expect_warning(scene, "/extensions/EXT_lights_image_based/lights/0/specularImages/0/2",
                   "found 2 x 4 texels, expected 4 x 4");
    EXPECT_TRUE(scene.skies.empty());
    add_cube();
    light()["specularImageSize"] = 8;
    expect_warning(import(), "/extensions/EXT_lights_image_based/lights/0/specularImageSize", "found 8");
}

TEST_F(ImageLightImport, WhatIsBeyondNumbersIsLeftOut) {
    add_even_coefficients(1e37f);
    light()["intensity"] = 1000;
    const SceneData scene = import();
    EXPECT_TRUE(scene.skies.empty());
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0],
              "/extensions/EXT_lights_image_based/lights/0: found radiance beyond 32-bit numbers; the "
              "environment is left out");
}

TEST_F(ImageLightImport, WrongReferencesAndTypesAreRefused) {
    const std::string place = "/extensions/EXT_lights_image_based/lights/0";
    expect_refused(place, "neither");
    light()["irradianceCoefficients"] = {{1, 2, 3}};
    expect_refused(place + "/irradianceCoefficients", "9");
    add_even_coefficients(1);
    light()["irradianceCoefficients"][4] = {1, "two", 3};
    expect_refused(place + "/irradianceCoefficients/4", "three");
    add_even_coefficients(1);
    light()["specularImages"] = {{0, 0, 0, 0, 0, 9}};
    expect_refused(place + "/specularImages/0", "six indices");
    light()["specularImages"] = 7;
    expect_refused(place + "/specularImages");
    light().erase("specularImages");
    light()["rotation"] = {1, 2};
    expect_refused(place + "/rotation");
    light().erase("rotation");
    light()["intensity"] = "much";
    expect_refused(place + "/intensity");
    light().erase("intensity");
    scene_light() = 3;
    expect_refused("/scenes/0/extensions/EXT_lights_image_based/light", "below 1");
}

TEST_F(ImageLightImport, OnlyTheLoadedScenesLight) {
    add_even_coefficients(1);
    builder.json["scenes"].push_back({{"nodes", {0}}});
    builder.json["scene"] = 1;
    EXPECT_TRUE(import().skies.empty());
    builder.json["extensionsRequired"] = {"EXT_lights_image_based"};
    builder.json["scene"] = 0;
    EXPECT_EQ(import().skies.size(), 1u);
}

}  // namespace
}  // namespace lanthorn
