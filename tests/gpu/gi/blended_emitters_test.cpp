// What is blended and glows lights a room as the picture shows it: emission times alpha.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/reference/path_settings.h"
#include "tests/gpu/gi/gather_scene.h"
#include "tests/gpu/gi/path_truth.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(64);
constexpr int kFrames = 18, kSpp = 256;
constexpr int kBounces = 8;  // of the reference; 0.5^8 of the light is left
constexpr float kNits = 2000, kAlpha = 0.3f;

Material glowing(AlphaMode mode, float alpha) {
    Material m = support::lamp(vec3(kNits));
    m.double_sided = true;
    m.alpha_mode = mode;
    m.base_colour.a = alpha;
    return m;
}

// As bright as one that is blended, but solid.
Material twin(float alpha) {
    Material m = glowing(AlphaMode::opaque, 1);
    m.emissive *= alpha;
    return m;
}

// A room of 6 x 3 x 4 m with a panel of 80 cm that faces both ways and a card that stands upright, both of
// the second material and out of view.
FrameScene lit_room(const Material& lamps) {
    return scene_of({box(vec3(-3, 0, -2), vec3(3, 3, 2), true, 0),
                     quad(vec3(-1.9f, 2.2f, -0.4f), vec3(0.8f, 0, 0), vec3(0, 0, 0.8f), 1),
                     quad(vec3(-2.5f, 0.5f, 0.8f), vec3(0.5f, 0, 0.3f), vec3(0, 0.9f, 0), 1),
                     box(vec3(-0.6f, 0, -0.3f), vec3(0, 1, 0.5f), false, 0)},
                    {lambertian(vec3(0.5f)), lamps}, {}, vec3(2.8f, 1.6f, 1.7f), vec3(1, 0.9f, -2));
}

// Of one instance alone: 0.2 at the left, 0.8 at the right.
FrameScene faded(FrameScene scene) {
    SceneAssets assets = *scene.assets;
    assets.meshes.edit(1, [](Mesh& mesh) {
        for (std::size_t i = 0; i < 4; ++i) {
            mesh.vertices[i].colour.a = i % 3 == 0 ? 0.2f : 0.8f;
        }
    });
    scene.assets = std::make_shared<const SceneAssets>(std::move(assets));
    return scene;
}

struct ByEmc {
    Deviation indirect, radiance;
};

ByEmc by_emc(const FrameScene& scene) {
    Bench bench;
    EmcSettings& settings = bench.settings.edit<EmcSettings>();
    settings.final_stage = EmcFinal::gather;
    settings.rays = EmcRays::bvh;
    settings.gather_source = GatherSource::photons;
    ByEmc result;
    result.indirect =
        against(still_picture(bench, scene, kFrames, kSize), path_traced(scene, kSize, kBounces, kSpp));
    result.radiance = against(bench.renderer().read(render::Aov::radiance),
                              path_traced(scene, kSize, kBounces, kSpp, reference::PathAov::radiance));
    return result;
}

void print(const char* name, const ByEmc& found) {
    std::printf("%s: indirect flux %.3f, relRMSE %.3f; radiance %.3f, %.3f\n", name, found.indirect.mean,
                found.indirect.rel_rmse, found.radiance.mean, found.radiance.rel_rmse);
}

// As near to `path` as with lamps that are solid; by those that fade, too.
TEST(BlendedEmitters, LightARoomAsSolidOnesDo) {
    const ByEmc solid = by_emc(lit_room(twin(kAlpha)));
    const ByEmc blended = by_emc(lit_room(glowing(AlphaMode::blend, kAlpha)));
    const ByEmc fades = by_emc(faded(lit_room(glowing(AlphaMode::blend, 1))));
    print("solid", solid);
    print("blended", blended);
    print("faded", fades);
    EXPECT_NEAR(blended.indirect.mean, solid.indirect.mean, 0.02);
    EXPECT_LT(blended.indirect.rel_rmse, 1.1 * solid.indirect.rel_rmse);
    EXPECT_NEAR(blended.radiance.mean, solid.radiance.mean, 0.02);
    EXPECT_LT(blended.radiance.rel_rmse, 1.1 * solid.radiance.rel_rmse);
    EXPECT_NEAR(fades.indirect.mean, 1, 0.02);
    EXPECT_LT(fades.indirect.rel_rmse, 0.03);
    EXPECT_NEAR(fades.radiance.mean, 1, 0.02);
    EXPECT_LT(fades.radiance.rel_rmse, 0.035);
}

// Light of the first reflection, by every technique there is: as much of what `path` finds as with lamps that
// are solid.
TEST(BlendedEmitters, EveryTechniqueHasTheirLight) {
    const std::vector<FrameScene> rooms{lit_room(twin(kAlpha)), lit_room(glowing(AlphaMode::blend, kAlpha))};
    const std::vector<Truth> truths{path_traced(rooms[0], kSize, 1, kSpp),
                                    path_traced(rooms[1], kSize, 1, kSpp)};
    for (std::size_t kind = 0; kind < techniques().size(); ++kind) {
        const std::string& name = techniques()[kind].name;
        if (name == "none") {
            continue;
        }
        std::vector<double> found;
        for (std::size_t i = 0; i < 2; ++i) {
            Bench bench(static_cast<TechniqueKind>(kind));
            bench.settings.bounces = 1;
            bench.settings.edit<EmcSettings>().gather_endless = false;
            bench.settings.edit<reference::PathSettings>().transport = reference::Transport::diffuse;
            found.push_back(against(still_picture(bench, rooms[i], 8, kSize), truths[i]).mean);
        }
        std::printf("%s: solid %.3f, blended %.3f\n", name.c_str(), found[0], found[1]);
        EXPECT_NEAR(found[1] / found[0], 1, 0.05) << name;
    }
}

// No light and no work: the picture of a room without them, bit for bit.
TEST(BlendedEmitters, WithoutAlphaTheyAreNotThere) {
    FrameScene with = lit_room(glowing(AlphaMode::blend, 0));
    const auto add_lamp = [](FrameScene& scene) {
        scene.lights.push_back(point_light(vec3(0, 2.2f, 0), 200));
    };
    add_lamp(with);
    FrameScene without = scene_of({box(vec3(-3, 0, -2), vec3(3, 3, 2), true, 0),
                                   box(vec3(-0.6f, 0, -0.3f), vec3(0, 1, 0.5f), false, 0)},
                                  {lambertian(vec3(0.5f))}, {}, vec3(2.8f, 1.6f, 1.7f), vec3(1, 0.9f, -2));
    add_lamp(without);
    Bench a, b;
    EXPECT_EQ(a.frame(with, kSize).pixels, b.frame(without, kSize).pixels);
    EXPECT_EQ(a.renderer().emissive().count(), 0);
}

}  // namespace
}  // namespace lanthorn::gi::test
