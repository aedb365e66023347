// Materials and skies at the ends of their ranges, by both final stages: the light of mirrors and glass stays
// finite, within what is emitted and within its photons, and as bright as the path tracer has it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>

#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/assets/sky_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/reference/path_tracer.h"
#include "tests/extremes/scenes.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::extremes {
namespace {

constexpr ivec2 kSize(48);
constexpr int kPhotons = 20'000;

struct Bounds {
    double least = 0.92, most = 1.08;
};

struct MaterialRow {
    std::string name;
    std::function<FrameScene()> scene;
    // Bounds of the mean over the path tracer's.
    Bounds by_gather{}, by_splats{};
    // Of what: irradiance, or where no surface that scatters light is in view, what is shown; nothing where
    // the path tracer does not find the light, or there is none.
    enum { irradiance, radiance, nothing } what = irradiance;
    bool lights = true;               // there is light to be seen
    double lumen = kPi * 300 * 0.64;  // that falls in, at most: a panel's
};

Material glass(float ior, float roughness, float thickness = 0.5f) {
    Material m;
    m.metallic = 0;
    m.roughness = roughness;
    m.transmission = 1;
    m.ior = ior;
    m.thickness = thickness;
    return m;
}

Material metal(float roughness) {
    Material m;
    m.base_colour = vec4(0.9f, 0.8f, 0.5f, 1);
    m.roughness = roughness;
    return m;
}

// The ordinary room under a panel, with something in its middle.
Stage with(const Mesh& thing, const Material& material) {
    Stage stage = room();
    stage.lights.clear();
    stage.materials.push_back(gi::test::lamp(vec3(300)));
    stage.meshes.push_back(gi::test::quad(vec3(2.6f, 2.59f, 1.2f), vec3(0.8f, 0, 0), vec3(0, 0, 0.8f), 3));
    stage.materials.push_back(material);
    stage.meshes.push_back(thing);
    stage.meshes.back().material = 4;
    return stage;
}

MaterialRow with_ball(std::string name, const Material& material) {
    return {.name = std::move(name), .scene = [material] {
                return frame_of(with(support::sphere(vec3(3, 1.1f, 1.7f), 0.4f, 3, false, 4), material), {});
            }};
}

// Before the camera, wider than its view.
MaterialRow before_the_eye(std::string name, const Material& material) {
    // What is seen through glass has been reflected once less than what is seen without. With splats, mirrors
    // and glass show direct light and caustics alone.
    return {.name = std::move(name),
            .scene =
                [material] {
                    Stage stage = room();
                    const vec3 on = glm::normalize(stage.target - stage.eye);
                    const vec3 right = glm::normalize(glm::cross(on, vec3(0, 1, 0))),
                               up = glm::cross(right, on);
                    const vec3 corner = stage.eye + 0.1f * on - 0.2f * (right + up);
                    return frame_of(with(gi::test::quad(corner, 0.4f * right, 0.4f * up, 4), material), {});
                },
            .by_gather = {0.75, 1.08},
            .by_splats = {0.45, 1.08},
            .what = MaterialRow::radiance};
}

MaterialRow lamp_inside_glass() {
    MaterialRow row = with_ball("a light inside glass", glass(1.5f, 0));
    row.scene = [] {
        Stage stage = with(support::sphere(vec3(3, 1.1f, 1.7f), 0.4f, 4, false, 4), glass(1.5f, 0));
        stage.meshes.erase(stage.meshes.begin() + 3);
        stage.meshes.push_back(support::sphere(vec3(3, 1.1f, 1.7f), 0.1f, 2, false, 3));
        return frame_of(stage, {});
    };
    // Its maps do not see into the glass: photons leave it as if it were not there, and its caustics come on
    // top.
    row.by_splats.most = 1.6;
    row.by_gather.most = 1.22;
    return row;
}

MaterialRow two_thousand_mirrors() {
    return {.name = "2000 mirrors", .scene = [] {
                Stage stage =
                    with(gi::test::box(vec3(2.6f, 0.3f, 1), vec3(2.62f, 0.32f, 1.02f), false, 4), metal(0));
                for (int i = 1; i < 2000; ++i) {
                    const vec3 p = vec3(2.6f, 0.3f, 1) + 0.1f * vec3(i % 12, i / 12 % 12, i / 144);
                    stage.meshes.push_back(gi::test::box(p, p + vec3(0.02f), false, 4));
                }
                return frame_of(stage, {});
            }};
}

// A ball on a floor under a sky.
FrameScene under(const std::function<vec3(std::uint32_t, std::uint32_t)>& radiance, const Material& ball) {
    FrameScene scene =
        gi::test::scene_of({gi::test::quad(vec3(-3, 0, 3), vec3(6, 0, 0), vec3(0, 0, -6), 0),
                            support::sphere(vec3(0, 0.6f, 0), 0.5f, 3, false, 1)},
                           {gi::test::lambertian(vec3(0.5f)), ball}, {}, vec3(0, 2, 3), vec3(0, 0.3f, 0));
    SkyImage image;
    image.height = 32;
    image.width = 64;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            image.radiance.push_back(radiance(x, y));
        }
    }
    SkyInstance sky;
    sky.sky.image = std::make_shared<const SkyImage>(std::move(image));
    scene.sky = sky;
    return scene;
}

std::vector<MaterialRow> rows() {
    const auto dark = [](auto, auto) { return vec3(0); };
    const auto one_bright = [](std::uint32_t x, std::uint32_t y) {
        return x == 20 && y == 8 ? vec3(1e6f) : vec3(1);
    };
    const double pixel = (kPi / 32) * (kPi / 32);  // sr, at most
    const double falls_in = 36 * (1e6 * pixel + 2 * kPi);
    MaterialRow black{.name = "a black sky",
                      .scene = [=] { return under(dark, metal(0.1f)); },
                      .what = MaterialRow::nothing,
                      .lights = false,
                      .lumen = 0};
    MaterialRow bright{.name = "a sky with one pixel of 1e6",
                       .scene = [=] { return under(one_bright, metal(0.1f)); },
                       .lumen = falls_in};
    MaterialRow black_glass = black, bright_glass = bright;
    black_glass.name += ", glass";
    black_glass.scene = [=] { return under(dark, glass(1.5f, 0)); };
    bright_glass.name += ", glass";
    bright_glass.scene = [=] { return under(one_bright, glass(1.5f, 0)); };
    return {with_ball("glass of ior 1", glass(1, 0)),
            with_ball("glass of ior 3", glass(3, 0)),
            with_ball("a thin wall of ior 3", glass(3, 0, 0)),
            with_ball("metal of roughness 0", metal(0)),
            with_ball("metal of roughness 1", metal(1)),
            with_ball("glass of roughness 1", glass(1.5f, 1)),
            before_the_eye("a mirror that fills the view", metal(0)),
            before_the_eye("thin glass that fills the view", glass(1.5f, 0, 0)),
            lamp_inside_glass(),
            two_thousand_mirrors(),
            std::move(black),
            std::move(bright),
            std::move(black_glass),
            std::move(bright_glass)};
}

class Materials : public testing::TestWithParam<MaterialRow> {
  protected:
    static void SetUpTestSuite() { gi::add_embree_rays(); }
    static void holds(gi::EmcFinal final_stage);
};

double mean_of(const std::vector<float>& values, const std::vector<float>& weights) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += static_cast<double>(values[i]) * static_cast<double>(weights[i]);
    }
    return sum / static_cast<double>(values.size());
}

void Materials::holds(gi::EmcFinal final_stage) {
    const MaterialRow& row = GetParam();
    FrameScene scene = row.scene();
    gi::test::Bench bench;
    bench.settings.edit<gi::EmcSettings>().final_stage = final_stage;
    bench.settings.edit<gi::EmcSettings>().gather_endless = false;
    bench.settings.edit<gi::EmcSettings>().rays = gi::EmcRays::bvh;
    bench.settings.edit<gi::EmcSettings>().caustic_photons = kPhotons;
    ImageF lux;
    for (int frame = 0; frame < 4; ++frame) {
        lux = bench.frame(scene, kSize);
        gi::test::hold_still(scene);
    }
    for (const render::Aov aov :
         {render::Aov::indirect, render::Aov::direct, render::Aov::radiance, render::Aov::final}) {
        for (const float v : bench.renderer().read(aov).pixels) {
            ASSERT_TRUE(std::isfinite(v) && v >= 0) << v;
        }
    }
    const gi::GiStatistics statistics = bench.technique().statistics(false);
    EXPECT_EQ(statistics.nan_count + bench.renderer().nan_count(), 0u);
    const auto& caustics = statistics.of<gi::CausticStatistics>();
    EXPECT_LE(caustics.emitted, static_cast<std::uint64_t>(kPhotons));
    EXPECT_LE(caustics.flux_stored.y, 1.05 * row.lumen);
    EXPECT_LE(caustics.flux_scattered.y, bench.settings.bounces * row.lumen);
    EXPECT_EQ(std::ranges::any_of(bench.renderer().read(render::Aov::radiance).pixels,
                                  [](float v) { return v > 0; }),
              row.lights);
    std::printf("caustics: %.4g lm straight, %.4g scattered\n", caustics.flux_stored.y,
                caustics.flux_scattered.y);
    if (row.what == MaterialRow::nothing) {
        return;
    }
    reference::PathSettings path;
    path.transport = reference::Transport::full;
    path.bounces = bench.settings.bounces;
    path.spp = 128;
    const bool shown = row.what == MaterialRow::radiance;
    scene = row.scene();
    reference::PathTracer tracer(scene, kSize, path, {.indirect = !shown, .radiance = shown});
    tracer.render({});
    // What glass and metal get as irradiance shows nowhere.
    const std::vector<float> weights =
        shown ? std::vector<float>(lux.pixels.size(), 1) : tracer.image(reference::PathAov::albedo);
    const double ratio =
        mean_of(shown ? bench.renderer().read(render::Aov::radiance).pixels : lux.pixels, weights) /
        mean_of(tracer.image(shown ? reference::PathAov::radiance : reference::PathAov::indirect), weights);
    std::printf("%s: mean %.3f of the path tracer's\n", row.name.c_str(), ratio);
    const Bounds& bounds = final_stage == gi::EmcFinal::gather ? row.by_gather : row.by_splats;
    EXPECT_GE(ratio, bounds.least);
    EXPECT_LE(ratio, bounds.most);
}

TEST_P(Materials, HoldBySplats) {
    holds(gi::EmcFinal::splat);
}
TEST_P(Materials, HoldByGather) {
    holds(gi::EmcFinal::gather);
}

void PrintTo(const MaterialRow& row, std::ostream* out) {
    *out << row.name;
}

std::string name_of(const testing::TestParamInfo<MaterialRow>& info) {
    std::string name = info.param.name;
    for (char& c : name) {
        c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(Gi, Materials, testing::ValuesIn(rows()), name_of);

// An environment image that breaks off is refused in a line that names it.
TEST(DamagedSky, IsRefused) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "lanthorn-extremes-damaged.hdr";
    std::ofstream(file, std::ios::binary) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n\x02\x02";
    std::vector<SkySun> suns;
    try {
        read_sky(file, suns);
        ADD_FAILURE() << "it was read";
    } catch (const InputError& error) {
        const std::string line = error.what();
        EXPECT_NE(line.find(file.filename().string()), std::string::npos) << line;
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    }
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace lanthorn::extremes
