// The real `lanthorn measure costs`: what it writes of scenes whose lights are known, and what it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/load_scene.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/refused.h"
#include "tests/unit/tools/run_program.h"
#include "tools/scene_generator/glb_bytes.h"
#include "tools/scene_generator/scenes.h"
#include "tools/workbench/measure/scene_memory.h"

namespace lanthorn {
namespace costs_command_test {

using nlohmann::json;
using testing_tools::file_bytes;
using testing_tools::Outcome;
using Words = std::vector<std::string>;

class CostsCommand : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    // Small and quick. `warmup`: frames before those that are measured; after 16 the gather rests.
    static Outcome run(const std::string& scene, const std::string& output, const Words& more = {},
                       const std::string& warmup = "18") {
        Words words{"measure", "costs",    scene,      "-o",    output,
                    "--size",  "48x48",    "--warmup", warmup,  "--frames",
                    "4",       "--rounds", "1",        "--set", "gi.emc.candidates=16"};
        words.insert(words.end(), more.begin(), more.end());
        return testing_tools::run_program(LANTHORN_BINARY, words);
    }
    // What costs.json says of the first scene.
    json measure(const std::string& scene, const Words& more = {}, const std::string& warmup = "18") const {
        const Outcome result = run(scene, path("out"), more, warmup);
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        EXPECT_EQ(testing_tools::files_in(path("out")), (Words{"costs.html", "costs.json"}));
        return json::parse(file_bytes(path("out/costs.json"))).at("scenes").at(0);
    }
    // At rest and in a walk; measured once, which takes most of the tests' time.
    const json& cornell_without_muted_lights() const {
        static const json measured = measure(kCornell, {"--motion", "walk", "--lights", "0"});
        return measured;
    }
    // The Cornell box with one lamp more, of so many candela, where its own hangs.
    std::string with_lamp(float candela) const {
        SceneData scene = scene_generator::cornell();
        NodeData node;
        node.name = "added";
        node.light = static_cast<std::uint32_t>(scene.lights.size());
        node.local.translation = dvec3(0.1, 0.3, 0.1);
        Light light;
        light.intensity = candela;
        scene.lights.push_back(light);
        scene.nodes.push_back(node);
        std::ofstream(path("two.glb"), std::ios::binary) << scene_generator::glb_bytes(scene);
        return path("two.glb");
    }
    static const json* light_of(const json& scene, const std::string& name) {
        for (const json& light : scene.at("lights")) {
            if (light.at("light") == name) {
                return &light;
            }
        }
        return nullptr;
    }
    inline static const std::string kCornell = support::repository_file("assets/cornell.glb");
    testing_tools::TemporaryFolder folder_;
};

TEST_F(CostsCommand, PartsSumUpAtRestAndInMotion) {
    const json& scene = cornell_without_muted_lights();
    ASSERT_EQ(scene.at("motions").size(), 2u);
    double gather[2] = {0, 0};
    for (std::size_t m = 0; m < 2; ++m) {
        const json& motion = scene.at("motions").at(m);
        EXPECT_EQ(motion.at("motion"), m == 0 ? "rest" : "walk");
        const double whole = motion.at("whole").at("ms");
        double sum = 0, mean = 0;
        for (const json& pass : motion.at("passes")) {
            EXPECT_GE(pass.at("ms"), -1e-3) << pass;
            sum += pass.at("ms").get<double>();
            mean += pass.at("mean").get<double>();
            gather[m] += pass.at("indirect").get<bool>() ? pass.at("ms").get<double>() : 0;
        }
        EXPECT_NEAR(sum, motion.at("passes_ms").get<double>(), 1e-9 * whole);
        EXPECT_NEAR(sum + motion.at("rest_ms").get<double>(), whole, 1e-9 * whole);
        double rest = 0;
        for (const json& line : motion.at("rest")) {
            rest += line.at("ms").get<double>();
        }
        EXPECT_NEAR(rest, motion.at("rest_ms").get<double>(), 1e-9 * whole);
        EXPECT_GE(motion.at("rest").at(0).at("ms"), 0) << "no pass takes longer than the frame it is in";
        EXPECT_LE(mean, motion.at("whole").at("mean").get<double>()) << "means add up without a rest below 0";
        EXPECT_EQ(motion.at("nan_count"), 0);
    }
    EXPECT_GT(gather[1], 2 * gather[0]) << "indirect light costs more while the camera walks";
    const json& memory = scene.at("memory");
    double parts = 0;
    for (const json& part : memory.at("parts")) {
        EXPECT_GE(part.at("gpu_mb"), 0) << part;
        parts += part.at("gpu_mb").get<double>();
    }
    EXPECT_NEAR(parts, memory.at("gpu_mb").get<double>(), 1e-6);
    EXPECT_GT(memory.at("lit_texels"), 100);
    EXPECT_GT(memory.at("remembered_rays"), 100);
}

TEST_F(CostsCommand, WhatThePlanLeavesOutIsNamedWithItsReasonAndItsRule) {
    const json& left_out = cornell_without_muted_lights().at("motions").at(0).at("left_out");
    const auto line = [&](const std::string& pass) {
        for (const json& of : left_out.at("lines")) {
            if (of.at("pass") == pass) {
                return of;
            }
        }
        return json();
    };
    const json caustics = line("caustic_photons"), gather = line("gather");
    ASSERT_FALSE(caustics.is_null());
    EXPECT_EQ(caustics.at("why"), "no specular or transmissive surface");
    EXPECT_TRUE(caustics.at("rules").empty()) << "no rule brings mirrors into the scene";
    ASSERT_FALSE(gather.is_null()) << "at rest no ray is shot";
    EXPECT_FALSE(gather.at("why").get<std::string>().empty());
    double most = 0;
    for (const json& rule : left_out.at("rules")) {
        EXPECT_FALSE(rule.at("leaves_out").get<std::string>().empty());
        most = std::max(most, rule.at("ms").get<double>());
    }
    EXPECT_EQ(left_out.at("rules").size(), 10u);
    EXPECT_GT(most, 0) << "some work was left out";
    bool named = false;
    for (const json& of : left_out.at("lines")) {
        named = named || !of.at("rules").empty();
        EXPECT_EQ(of.at("ms").is_null(), of.at("rules").empty()) << of;
    }
    EXPECT_TRUE(named);
}

TEST_F(CostsCommand, TwoLightsAreBothMutedAndShareTheLight) {
    const json scene = measure(with_lamp(20), {}, "1");
    ASSERT_EQ(scene.at("lights").size(), 2u) << scene.at("lights");
    const json* added = light_of(scene, "added");
    ASSERT_NE(added, nullptr);
    double shares = 0;
    for (const json& light : scene.at("lights")) {
        EXPECT_TRUE(std::isfinite(light.at("motions").at("rest").at("ms").get<double>()));
        EXPECT_GT(light.at("share"), 0.01) << light;
        shares += light.at("share").get<double>();
    }
    EXPECT_NEAR(shares, 1, 1e-9);
    EXPECT_EQ(added->at("kind"), "lamp");
}

TEST_F(CostsCommand, ALampThatDoesNotShineGivesNothing) {
    const json scene = measure(with_lamp(0), {"--lights", "1"}, "1");
    const json* added = light_of(scene, "added");
    ASSERT_NE(added, nullptr) << scene.at("lights");
    EXPECT_EQ(added->at("share"), 0);
    EXPECT_TRUE(added->at("motions").at("rest").is_null())
        << "the one that gives most is muted, this one not";
    EXPECT_FALSE(scene.at("lights").at(0).at("motions").at("rest").is_null());
}

TEST_F(CostsCommand, MeshesTakeWhatIsUploaded) {
    const auto context = gpu::create_headless_context();
    for (const char* name : {"cornell", "living-room"}) {
        workbench::SceneView view;
        ShownScene shown(
            workbench::load_scene(support::repository_file("assets/" + std::string(name) + ".glb"), view),
            view);
        SettingsSchema schema;
        workbench::declare_all_settings(schema);
        Settings settings(schema);
        settings.set_from_text("gi.technique=none");
        gi::add_picture_plugins(shown.app(), settings);
        shown.app().view().size = ivec2(16);
        shown.show_at(0);
        const auto& uploaded =
            std::as_const(shown).world().resource<Renderer>().frame->gpu_scene().uploaded();
        std::uint64_t meshes = 0, images = 0;
        for (const workbench::AssetBytes& mesh : workbench::mesh_bytes(shown.frame())) {
            meshes += mesh.gpu;
        }
        for (const workbench::AssetBytes& image : workbench::image_bytes(*shown.frame().assets)) {
            images += image.gpu;
        }
        EXPECT_EQ(meshes, uploaded.geometry) << name;
        EXPECT_GE(images, uploaded.images) << name << ": mipmaps come on top";
        EXPECT_LE(images, uploaded.images + uploaded.images / 2) << name;
    }
}

TEST_F(CostsCommand, TheJsonIsPrintedAsWritten) {
    const Outcome result = run(kCornell, path("a/b"), {"--json", "--technique", "none", "--lights", "0"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(json::parse(result.out), json::parse(file_bytes(path("a/b/costs.json"))));
    EXPECT_EQ(json::parse(result.out).at("technique"), "none");
    EXPECT_NE(file_bytes(path("a/b/costs.html")).find("</html>"), std::string::npos);
}

TEST_F(CostsCommand, BadInputIsOneLineAndLeavesNothing) {
    const auto refused = [&](const Outcome& result, const std::string& part) {
        testing_tools::expect_refusal(result, part);
        EXPECT_TRUE(folder_.files().empty()) << part;
    };
    refused(testing_tools::run_program(LANTHORN_BINARY, {"measure", "costs", "-o", path("out")}), "SCENE");
    refused(testing_tools::run_program(LANTHORN_BINARY, {"measure", "costs", kCornell}), "--output");
    refused(run(path("nowhere.glb"), path("out")), "nowhere.glb");
    refused(run(kCornell + "@roof", path("out")), "roof");
    refused(run(kCornell, path("out"), {"--technique", "radiosity"}), "radiosity");
    refused(run(kCornell, path("out"), {"--preset", "best"}), "best");
    refused(run(kCornell, path("out"), {"--motion", "jump"}), "jump");
    refused(run(kCornell, path("out"), {"--size", "48"}), "--size");
    refused(run(kCornell, "/dev/null/out"), "/dev/null/out");
}

TEST_F(CostsCommand, ASceneWithoutLightIsRefusedWhereNoneIsLent) {
    SceneData scene = scene_generator::cornell();
    for (NodeData& node : scene.nodes) {
        node.light = kNone;
    }
    for (Material& material : scene.materials) {
        material.emissive = vec3(0);
    }
    std::ofstream(path("dark.glb"), std::ios::binary) << scene_generator::glb_bytes(scene);
    testing_tools::expect_refusal(run(path("dark.glb"), path("out"), {"--no-default-light"}),
                                  "found no light");
    EXPECT_EQ(folder_.files(), Words{"dark.glb"});
}

TEST_F(CostsCommand, AFullDiskLeavesNoHalfFile) {
    std::filesystem::create_directory(path("out"));
    const Outcome result = [&] {
        const support::FileSizeLimit limit(300);
        return run(kCornell, path("out"), {"--technique", "none", "--lights", "0"});
    }();
    testing_tools::expect_refusal(result, "costs.json: cannot be written: File too large");
    EXPECT_TRUE(testing_tools::files_in(path("out")).empty());
}

}  // namespace costs_command_test
}  // namespace lanthorn
