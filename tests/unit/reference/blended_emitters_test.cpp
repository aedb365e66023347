// What is blended shines as much as it covers: emission times alpha, on paper.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "gi_module/reference/emitters.h"
#include "tests/support/closed_forms.h"
#include "tests/unit/reference/scenes.h"

namespace lanthorn::reference::test {
namespace blended_emitters_test {

constexpr float kNits = 10;

Material glowing(float alpha, const vec3& albedo = vec3(0)) {
    Material m = lambertian(albedo);
    m.emissive = vec3(kNits);
    m.alpha_mode = AlphaMode::blend;
    m.base_colour.a = alpha;
    return m;
}

class BlendedEmitters : public testing::TestWithParam<std::tuple<float, Transport>> {
  protected:
    float alpha() const { return std::get<0>(GetParam()); }
    PathSettings settings(int spp) const {
        PathSettings result;
        result.transport = std::get<1>(GetParam());
        result.spp = spp;
        return result;
    }
};

// Lux that arrive below a panel of 2 a by 2 a that hangs `height` over a white floor.
double under_a_panel(const Material& panel, double a, double height, const PathSettings& settings) {
    const auto half = static_cast<float>(a);
    FrameScene scene =
        scene_of({quad({-half, static_cast<float>(height), -half}, {2 * half, 0, 0}, {0, 0, 2 * half}, 0),
                  quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, 1)},
                 {panel, lambertian(vec3(1))}, {}, vec3(0), vec3(0, 0, 1));
    look_closely(scene, vec3(0, 0.01f, 0), vec3(0), 0.001f);
    return static_cast<double>(kPi) * mean_of(scene, settings, PathAov::direct);
}

// Small and far, where lights are drawn, and large and near, where directions find them.
TEST_P(BlendedEmitters, APanelLightsAsItsFormFactorAndAlphaSay) {
    for (const auto& [half, height] : {std::pair{0.05, 1.0}, {0.2, 0.2}, {5.0, 0.1}}) {
        const double exact = support::kPiD * static_cast<double>(kNits * alpha()) * 4 *
                             support::parallel_corner(half, half, height);
        EXPECT_NEAR(under_a_panel(glowing(alpha()), half, height, settings(256)) / exact, 1, 0.015)
            << half << " m, " << height << " m up";
    }
}

// In a sphere that glows and reflects but is open where alpha leaves it: of what falls on it alpha times the
// albedo comes back, and it shines alpha times what it emits.
TEST_P(BlendedEmitters, AnOpenCavityIsTheGeometricSeries) {
    constexpr float kAlbedo = 0.8f;
    FrameScene scene =
        scene_of({sphere(vec3(0), 10, 4, true, 0), sphere(vec3(0, 0, -1), 0.1f, 4, false, 1)},
                 {glowing(alpha(), vec3(kAlbedo)), lambertian(vec3(0.5f))}, {}, vec3(0), vec3(0, 0, -1));
    scene.camera.camera.y_fov = 0.1f;
    PathSettings three = settings(alpha() < 0.5f ? 2048 : 128);  // few rays meet it
    three.bounces = 3;
    const double shines = static_cast<double>(alpha() * kNits), back = static_cast<double>(alpha() * kAlbedo);
    EXPECT_NEAR(mean_of(scene, three, PathAov::direct) / (0.5 * shines), 1, 0.01);
    const double reflected = back + back * back + back * back * back;
    EXPECT_NEAR(mean_of(scene, three, PathAov::indirect) / (support::kPiD * shines * reflected), 1, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Alphas, BlendedEmitters,
                         testing::Combine(testing::Values(0.1f, 0.5f, 0.9f),
                                          testing::Values(Transport::diffuse, Transport::full)));

// A texture that leaves a quarter of a panel, and vertex colours that fade it out.
TEST(BlendedEmitters, LightLeavesFromWhereAlphaIs) {
    PathSettings settings;
    settings.spp = 512;
    FrameScene scene = scene_of(
        {quad({0, 0.5f, 0}, {1, 0, 0}, {0, 0, 1}, 0), quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, 1)},
        {glowing(1), lambertian(vec3(1))}, {}, vec3(0), vec3(0, 0, 1));
    look_closely(scene, vec3(0, 0.01f, 0), vec3(0), 0.001f);
    const auto lux = [&] { return static_cast<double>(kPi) * mean_of(scene, settings, PathAov::direct); };
    const double whole = support::kPiD * static_cast<double>(kNits) * support::parallel_corner(1, 1, 0.5);
    EXPECT_NEAR(lux() / whole, 1, 0.01);
    SceneAssets assets = *scene.assets;
    Image image;
    image.width = image.height = 2;
    image.rgba = {255, 255, 255, 255, 255, 255, 255, 0, 255, 255, 255, 0, 255, 255, 255, 0};
    assets.images.push_back(image);
    Texture texture;
    texture.sampler.mag = Filter::nearest;
    assets.textures.push_back(texture);
    assets.materials.edit(0, [](Material& m) { m.base_colour_texture.texture = 0; });
    assets.meshes.edit(0, [](Mesh& m) {
        const std::array<vec2, 4> uv{vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1)};
        for (std::size_t i = 0; i < 4; ++i) {
            m.vertices[i].uv0 = uv[i];
        }
    });
    scene.assets = std::make_shared<const SceneAssets>(assets);
    const double quarter =
        support::kPiD * static_cast<double>(kNits) * support::parallel_corner(0.5, 0.5, 0.5);
    EXPECT_NEAR(lux() / quarter, 1, 0.01);

    assets.materials.edit(0, [](Material& m) { m.base_colour_texture = {}; });
    assets.meshes.edit(0, [](Mesh& m) {  // from 1 at the corner that is right above to 0
        for (Vertex& v : m.vertices) {
            v.colour.a = 1 - v.position.x;
        }
    });
    scene.assets = std::make_shared<const SceneAssets>(assets);
    double faded = 0;  // in strips, each of the alpha of its middle
    for (int i = 0; i < 1000; ++i) {
        const double x = i / 1000.0;
        faded += (1 - x - 0.0005) * (support::parallel_corner(x + 0.001, 1, 0.5) -
                                     (i > 0 ? support::parallel_corner(x, 1, 0.5) : 0.0));
    }
    EXPECT_NEAR(lux() / (support::kPiD * static_cast<double>(kNits) * faded), 1, 0.01);
}

// Those of a scene that is built again have the pieces that are kept, in any pose.
TEST(BlendedEmitters, ShareThePiecesThatAreKept) {
    FrameScene scene =
        scene_of({quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, 0)}, {glowing(0.5f)}, {}, vec3(0), vec3(0, 0, 1));
    const MaterialTable materials(*scene.assets);
    KeptEmissivePieces kept;
    TraceScene traced(scene, materials);
    const Emitters first(traced, materials, &kept);
    const auto pieces = kept.of(*scene.assets, 0);
    ASSERT_TRUE(pieces);
    EXPECT_EQ(pieces.use_count(), 3) << "here, where they are kept, and in the emitters";
    const Emitters second(traced, materials, &kept);
    EXPECT_EQ(pieces.use_count(), 4);
}

TEST(BlendedEmitters, WithoutAlphaThereIsNone) {
    const FrameScene scene =
        scene_of({quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, 0)}, {glowing(0)}, {}, vec3(0), vec3(0, 0, 1));
    const MaterialTable materials(*scene.assets);
    TraceScene traced(scene, materials);
    EXPECT_TRUE(Emitters(traced, materials).empty());
    EXPECT_EQ(under_a_panel(glowing(0), 1, 1, {}), 0);
}

}  // namespace blended_emitters_test
}  // namespace lanthorn::reference::test
