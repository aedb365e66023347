// The debug views that techniques declare.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/reference/path_settings.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"
#include "tests/gpu/gi/test_scene.h"
#include "tests/support/repository.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(96, 64);

FrameScene cornell() {
    ecs::World world;
    spawn(world, import_gltf(support::repository_file("assets/cornell.glb")));
    Transforms().update(world);
    return Extractor().extract(world, find_by_name(world, "camera"));
}

// A view of the third frame; its pixels, none if that has nothing of the kind.
std::vector<float> drawn(TechniqueKind kind, const std::string& view, EmcFinal final_stage) {
    Bench bench(kind);
    bench.settings.edit<EmcSettings>().final_stage = final_stage;
    bench.settings.edit<reference::PathSettings>().frame_spp = 4;
    FrameScene scene = cornell();
    scene.camera.position += vec3(0, 0, 1);  // so that some pixels show nothing
    scene.camera.view = glm::translate(scene.camera.view, vec3(0, 0, -1));
    for (int i = 0; i < 3; ++i) {
        bench.show(scene, kSize);
        hold_still(scene);
    }
    const std::vector<float> light = bench.renderer().read(render::Aov::indirect).pixels;
    const Renderer& shown = bench.app.world().resource<Renderer>();
    const gpu::Texture picture = bench.technique().debug_view(view, shown.frame->inputs(scene, *shown.timer));
    const std::vector<float> pixels = picture ? picture.read_floats(3) : std::vector<float>();
    EXPECT_EQ(bench.renderer().read(render::Aov::indirect).pixels, light) << "the view alters the picture";
    return pixels;
}

TEST(DebugViews, AreDrawnAndTellPlacesApart) {
    for (std::size_t kind = 0; kind < techniques().size(); ++kind) {
        const TechniqueEntry& technique = techniques()[kind];
        for (const DebugView& view : technique.debug_views) {
            const std::string name = technique.name + ' ' + view.name;
            std::vector<float> pixels = drawn(static_cast<TechniqueKind>(kind), view.name, EmcFinal::gather);
            if (pixels.empty()) {
                pixels = drawn(static_cast<TechniqueKind>(kind), view.name, EmcFinal::splat);
            }
            ASSERT_FALSE(pixels.empty()) << name;
            EXPECT_TRUE(std::ranges::all_of(pixels, [](float v) { return std::isfinite(v) && v >= 0; }))
                << name;
            const auto [least, most] = std::ranges::minmax(pixels);
            EXPECT_LT(least, most) << name << " is constant";
            if (view.shown == DebugView::Shown::colour) {
                EXPECT_LE(most, 1.0f) << name;
            }
        }
    }
}

TEST(DebugViews, HaveNamesOfTheirOwn) {
    for (const TechniqueEntry& technique : techniques()) {
        std::set<std::string> names = {"final",  "indirect", "direct",  "albedo",
                                       "normal", "depth",    "radiance"};
        for (const DebugView& view : technique.debug_views) {
            EXPECT_TRUE(names.insert(view.name).second) << technique.name << ' ' << view.name;
            EXPECT_FALSE(view.docs.empty()) << technique.name << ' ' << view.name;
        }
        if (technique.name != "none") {
            EXPECT_GE(technique.debug_views.size(), technique.name == "emc" ? 4u : 2u) << technique.name;
        }
    }
}

TEST(DebugViews, AFrameWithoutLightHasNothingToShow) {
    FrameScene scene =
        scene_of({inward_sphere(1, 2, 0)}, {lambertian(vec3(0.5f))}, {}, vec3(0), vec3(0, 0, -1));
    for (std::size_t kind = 0; kind < techniques().size(); ++kind) {
        Bench bench(static_cast<TechniqueKind>(kind));
        bench.show(scene, kSize);
        const Renderer& shown = bench.app.world().resource<Renderer>();
        for (const DebugView& view : techniques()[kind].debug_views) {
            EXPECT_FALSE(bench.technique().debug_view(view.name, shown.frame->inputs(scene, *shown.timer)))
                << techniques()[kind].name << ' ' << view.name;
        }
    }
}

}  // namespace
}  // namespace lanthorn::gi::test
