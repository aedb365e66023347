// What every command shows of a scene: a bare model too, and the moment that is asked for.
#include <gtest/gtest.h>

#include <fstream>
#include <tuple>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/assets/sky_file.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"
#include "tools/scene_generator/glb_bytes.h"
#include "tools/scene_generator/scenes.h"
#include "tools/workbench/load/default_light.h"

namespace lanthorn {
namespace {

using testing_tools::Outcome;

class SceneViewOptions : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    static Outcome run(const std::vector<std::string>& arguments) {
        return testing_tools::run_program(LANTHORN_BINARY, arguments);
    }
    double mean(const std::string& name) const {
        const ImageF image = read_image(path(name));
        double sum = 0;
        for (const float v : image.pixels) {
            sum += v;
        }
        return sum / static_cast<double>(image.pixels.size());
    }
    testing_tools::TemporaryFolder folder_;
};

TEST_F(SceneViewOptions, ABareModelIsLitAndSeen) {
    SceneData scene = scene_generator::clutter();
    for (NodeData& node : scene.nodes) {
        node.light = kNone;
    }
    for (Material& material : scene.materials) {
        material.emissive = vec3(0);
    }
    const auto render = [&](const std::string& aov, const std::string& image) {
        std::ofstream(path("bare.glb"), std::ios::binary) << scene_generator::glb_bytes(scene);
        return run({"render", path("bare.glb"), "-o", path(image), "--size", "32x32", "--aov", aov,
                    "--preset", "low"});
    };
    const Outcome room = render("indirect", "a.exr");
    EXPECT_EQ(room.code, 0) << room.err;
    EXPECT_EQ(room.error_lines(), 1) << room.err;
    EXPECT_NE(room.err.find("found no light; one over"), std::string::npos) << room.err;
    EXPECT_GT(mean("a.exr"), 10) << "1000 lx fall on its walls";

    for (NodeData& node : scene.nodes) {
        node.camera = kNone;
    }
    const Outcome model = render("direct", "b.exr");
    EXPECT_EQ(model.code, 0) << model.err;
    EXPECT_EQ(model.error_lines(), 2) << model.err;
    EXPECT_NE(model.err.find("found no camera; one that sees everything"), std::string::npos) << model.err;
    EXPECT_GT(mean("b.exr"), 1);
}

TEST_F(SceneViewOptions, AnEnvironmentLightsTheScene) {
    ImageF sky{64, 32, 3, std::vector<float>(64 * 32 * 3, 50), {}};
    write_image(path("sky.exr"), sky);
    SceneData scene = scene_generator::clutter();
    for (NodeData& node : scene.nodes) {
        node.light = kNone;
        node.camera = kNone;
    }
    for (Material& material : scene.materials) {
        material.emissive = vec3(0);
    }
    std::ofstream(path("bare.glb"), std::ios::binary) << scene_generator::glb_bytes(scene);
    const auto render = [&](const std::string& environment, const std::string& intensity) {
        return run({"render", path("bare.glb"), "-o", path("e.exr"), "--size", "32x32", "--aov", "radiance",
                    "--preset", "low", "--environment", environment, "--environment-intensity", intensity});
    };
    const Outcome once = render(path("sky.exr"), "1");
    ASSERT_EQ(once.code, 0) << once.err;
    EXPECT_EQ(once.err.find("found no light"), std::string::npos) << once.err;
    const double one = mean("e.exr");
    EXPECT_GT(one, 10) << "the sky behind it, and its light";
    ASSERT_EQ(render(path("sky.exr"), "3").code, 0);
    EXPECT_NEAR(mean("e.exr") / one, 3, 0.01);
    const Outcome none = render(path("none.hdr"), "1");
    EXPECT_EQ(none.code, 2);
    EXPECT_EQ(none.error_lines(), 1) << none.err;
    EXPECT_NE(none.err.find("none.hdr: found no such file"), std::string::npos) << none.err;
    EXPECT_EQ(render(path("sky.exr"), "-1").code, 2);
}

TEST_F(SceneViewOptions, AnEnvironmentTakesThePlaceOfTheFiles) {
    SceneData scene;
    Sky own;
    own.image = std::make_shared<const SkyImage>(SkyImage{"own", 2, 1, {vec3(1), vec3(1)}});
    NodeData node;
    node.name = "own";
    add_sky_nodes(scene, node, own, {{.towards = vec3(0, 1, 0), .illuminance = vec3(5)}});
    ASSERT_EQ(scene.nodes.size(), 2u);
    write_image(path("sky.exr"), ImageF{8, 4, 3, std::vector<float>(8 * 4 * 3, 50), {}});
    workbench::add_environment(scene, path("sky.exr"), 1);
    EXPECT_EQ(scene.nodes[0].sky, kNone);
    EXPECT_EQ(scene.nodes[1].light, kNone) << "its sun";
    EXPECT_NE(scene.nodes.back().sky, kNone);
}

TEST_F(SceneViewOptions, TradeTellsMomentsApart) {
    for (const std::string time : {"0", "0.6"}) {
        const Outcome result =
            run({"trade", support::repository_file("assets/puppet.glb"), "-o", path("out"), "--technique",
                 "none", "--preset", "low", "--presets-only", "--size", "24x16", "--frames", "1", "--warmup",
                 "0", "--reference-spp", "2", "--time", time});
        ASSERT_EQ(result.code, 0) << result.err;
    }
    EXPECT_EQ(testing_tools::files_in(path("out/points")).size(), 4u) << "figures and picture of two moments";
    const auto references = testing_tools::files_in(path("out/references"));
    ASSERT_EQ(references.size(), 6u);
    EXPECT_NE(testing_tools::file_bytes(path("out/references/" + references[0])),
              testing_tools::file_bytes(path("out/references/" + references[1])));
}

TEST_F(SceneViewOptions, TradeTakesScenesByCameraAndRefusesOtherMotions) {
    const auto trade = [&](const std::string& scene, const std::string& motion) {
        return run({"trade", support::repository_file("assets/" + scene), "-o", path("out"), "--technique",
                    "none", "--preset", "low", "--presets-only", "--size", "24x16", "--frames", "1",
                    "--warmup", "0", "--reference-spp", "2", "--motion", motion});
    };
    const Outcome result = trade("two-rooms.glb@dark", "walk");
    ASSERT_EQ(result.code, 0) << result.err;
    for (const std::string& file : testing_tools::files_in(path("out/references"))) {
        EXPECT_EQ(file.rfind("two-rooms-dark-", 0), 0u) << file;
    }
    EXPECT_NE(testing_tools::file_bytes(path("out/trade.csv")).find("two-rooms-dark-walk,none"),
              std::string::npos);
    for (const auto& [scene, motion, problem] :
         {std::tuple("two-rooms.glb@dark", "jump", "jump"), std::tuple("two-rooms.glb@roof", "light", "roof"),
          std::tuple("two-rooms.glb", "figure", "it has no animation"),
          std::tuple("near-lamp.glb", "box", "no room for a box")}) {
        const Outcome refused = trade(scene, motion);
        EXPECT_EQ(refused.code, 2) << refused.err;
        EXPECT_EQ(refused.error_lines(), 1) << refused.err;
        EXPECT_NE(refused.err.find(problem), std::string::npos) << refused.err;
    }
}

// Of two scenes one has a figure; both have room for a box, which is in the reference, too.
TEST_F(SceneViewOptions, TradeLeavesOutAMotionThatASceneLacks) {
    const std::string puppet = support::repository_file("assets/puppet.glb");
    const std::string rooms = support::repository_file("assets/two-rooms.glb");
    const Outcome result = run({"trade",
                                puppet,
                                rooms,
                                "-o",
                                path("out"),
                                "--technique",
                                "none",
                                "--preset",
                                "low",
                                "--presets-only",
                                "--size",
                                "24x16",
                                "--frames",
                                "1",
                                "--warmup",
                                "0",
                                "--reference-spp",
                                "2",
                                "--motion",
                                "walk,box,figure"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.err.find(rooms + ": it has no animation, expected some for --motion figure: left out"),
              std::string::npos)
        << result.err;
    const std::string csv = testing_tools::file_bytes(path("out/trade.csv"));
    for (const char* row :
         {"puppet-walk,", "puppet-box,", "puppet-figure,", "two-rooms-walk,", "two-rooms-box,"}) {
        EXPECT_NE(csv.find(row), std::string::npos) << row;
    }
    EXPECT_EQ(csv.find("two-rooms-figure"), std::string::npos);
    EXPECT_EQ(testing_tools::files_in(path("out/references")).size(), 15u) << "five motions and scenes";
}

}  // namespace
}  // namespace lanthorn
