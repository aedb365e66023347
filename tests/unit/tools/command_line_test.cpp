// The real `lanthorn`, run as a user runs it.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lanthorn/assets/image_io.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/refused.h"
#include "tests/unit/tools/run_program.h"
#include "tools/scene_generator/glb_bytes.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn {
namespace {

using testing_tools::Outcome;

class CommandLine : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }

    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }
    std::string write(const std::string& name, const SceneData& scene) const {
        return write(name, scene_generator::glb_bytes(scene));
    }
    std::string write(const std::string& name, int width, int height, float value) const {
        ImageF image;
        image.width = width;
        image.height = height;
        image.channels = 3;
        image.pixels.assign(static_cast<std::size_t>(3 * width * height), value);
        write_image(path(name), image);
        return path(name);
    }

    static Outcome run(const std::vector<std::string>& arguments,
                       const std::vector<std::string>& environment = {}) {
        return testing_tools::run_program(LANTHORN_BINARY, arguments, environment);
    }

    // That exit code, one line on standard error that has `part`, and nothing new in the folder.
    void expect_refused(const std::vector<std::string>& arguments, const std::string& part,
                        int code = 2) const {
        const auto before = folder_.files();
        testing_tools::expect_refusal(run(arguments), part, arguments, code);
        EXPECT_EQ(folder_.files(), before) << testing::PrintToString(arguments);
    }

    static std::string cornell() { return support::repository_file("assets/cornell.glb"); }

    testing_tools::TemporaryFolder folder_;
};

TEST_F(CommandLine, HelpAndVersion) {
    for (const auto& arguments : std::vector<std::vector<std::string>>{
             {"--help"}, {"render", "--help"}, {"compare", "--help"}, {"inspect", "--help"}, {"--version"}}) {
        const Outcome result = run(arguments);
        EXPECT_EQ(result.code, 0);
        EXPECT_NE(result.out, "");
        EXPECT_EQ(result.err, "");
    }
}

TEST_F(CommandLine, BadUsage) {
    expect_refused({}, "subcommand");
    expect_refused({"paint"}, "paint");
    expect_refused({"render"}, "SCENE");
    expect_refused({"render", cornell()}, "-o");
    expect_refused({"render", cornell(), "-o", path("a.png"), "--frames", "0"}, "--frames");
    expect_refused({"render", cornell(), "-o", path("a.png"), "--frames", "many"}, "--frames");
    expect_refused({"render", cornell(), "-o", path("a.png"), "--nonsense"}, "--nonsense");
    for (const char* size : {"0x5", "512", "99999x2", "64x64x64"}) {
        expect_refused({"render", cornell(), "-o", path("a.png"), "--size", size}, "--size");
    }
    expect_refused({"render", cornell(), "-o", path("a.png"), "--aov", "shadow"}, "shadow");
    expect_refused({"render", cornell(), "-o", path("a.exr"), "--aov", "depth", "--aov", "depth"}, "twice");
}

TEST_F(CommandLine, BadSettings) {
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"render", cornell(), "-o", path("a.png")});
        return more;
    };
    expect_refused(with({"--set", "gi.emc.cout=8"}), "did you mean 'gi.emc.count'?");
    expect_refused(with({"--set", "gi.emc.count=100000"}),
                   "gi.emc.count: found '100000', expected an integer from");
    expect_refused(with({"--set", "gi.emc.count=nan"}), "gi.emc.count");
    expect_refused(with({"--set", "gi.emc.count"}), "NAME=VALUE");
    expect_refused(with({"--technique", "radiosity"}), "radiosity");
    expect_refused(with({"--preset", "best"}), "low, medium, high, ultra");
    expect_refused(with({"--seed", "-1"}), "gi.seed");
    expect_refused(with({"--settings", path("none.json")}), "none.json");
    const std::string bad = write("bad.json", R"({"gi.photons": "many"})");
    expect_refused(with({"--settings", bad}), "bad.json: gi.photons: found 'many'");
}

TEST_F(CommandLine, TradeAdvisesFromAFinishedChart) {
    const std::string chart = support::repository_file("docs/trade/techniques.csv");
    const Outcome result = run({"trade", "--from", chart, "--for-ms", "33,100", "--share", "0.75"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("33 ms"), std::string::npos);
    EXPECT_NE(result.out.find("corridor"), std::string::npos) << "each scene by itself";
    const Outcome one = run({"trade", "corridor", "--from", chart, "--for-error", "0.5", "--json"});
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_NE(one.out.find("\"worst_scene\": \"corridor\""), std::string::npos) << one.out;

    expect_refused({"trade", "--from", chart, "--for-ms", "0.1"}, "the cheapest takes", 1);
    expect_refused({"trade", "--from", chart, "--for-error", "0.001"}, "the least error is", 1);
    for (const char* limit : {"0", "-1", "many", "nan", "1,0"}) {
        expect_refused({"trade", "--from", chart, "--for-ms", limit}, "--for-ms");
        expect_refused({"trade", "--from", chart, "--for-error", limit}, "--for-error");
    }
    expect_refused({"trade", "--from", path("."), "--for-ms", "33"}, "trade.csv");
    expect_refused({"trade", "--from", cornell(), "--for-ms", "33"}, "trade.csv");
    expect_refused({"trade", "--from", chart}, "--for-ms");
    expect_refused({"trade", "attic", "--from", chart, "--for-ms", "33"}, "attic");
    expect_refused({"trade", "--from", chart, "-o", path("t"), "--for-ms", "33"}, "-o");
    expect_refused({"trade", cornell()}, "-o DIR");
    expect_refused({"trade", cornell(), "-o", path("t"), "--seeds", "0"}, "--seeds");
}

TEST_F(CommandLine, ListSettings) {
    const Outcome result = run({"render", "--list-settings"});
    EXPECT_EQ(result.code, 0);
    for (const char* part :
         {"gi.bounces", "gi.photons", "gi.emc.count", "gi.emc.resolution", "gi.emc.search", "cost:"}) {
        EXPECT_NE(result.out.find(part), std::string::npos) << part;
    }
}

TEST_F(CommandLine, BadScenes) {
    const std::string image = path("a.png");
    expect_refused({"render", path("missing.glb"), "-o", image}, "missing.glb");
    expect_refused({"inspect", path("missing.glb")}, "missing.glb");
    expect_refused({"render", folder_.path(), "-o", image}, folder_.path());
    const std::string whole = testing_tools::file_bytes(cornell());
    for (const std::size_t size : {0ul, 12ul, whole.size() - 1}) {
        const std::string truncated = write("truncated.glb", whole.substr(0, size));
        expect_refused({"render", truncated, "-o", image}, "truncated.glb");
    }
    const std::string wrong =
        write("wrong.gltf", R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": "one"}]})");
    expect_refused({"render", wrong, "-o", image}, "wrong.gltf");
}

TEST_F(CommandLine, NothingToRender) {
    const std::string image = path("a.png");
    SceneData scene = scene_generator::cornell();
    for (NodeData& node : scene.nodes) {
        node.camera = kNone;
    }
    scene.cameras.clear();
    expect_refused({"render", write("no-camera.glb", scene), "-o", image, "--camera", "0"},
                   "found no camera '0', expected one of none (--camera auto sees everything)");

    scene = scene_generator::cornell();
    for (Material& material : scene.materials) {
        material.emissive = vec3(0);
    }
    expect_refused({"render", write("no-light.glb", scene), "-o", image, "--no-default-light"}, "no light");
    expect_refused({"measure", "hits", path("no-light.glb"), "--no-default-light"}, "no light");

    scene = scene_generator::cornell();
    for (NodeData& node : scene.nodes) {
        node.meshes.clear();
    }
    expect_refused({"render", write("no-geometry.glb", scene), "-o", image}, "no geometry");

    expect_refused({"render", cornell(), "-o", image, "--camera", "sky"}, "expected one of 0 'camera'");
    expect_refused({"render", cornell(), "-o", image, "--camera", "1"}, "expected one of 0 'camera'");
}

TEST_F(CommandLine, UnwritableOutput) {
    expect_refused({"render", cornell(), "-o", path("none/a.png")}, "a.png");
    expect_refused({"render", cornell(), "-o", path("a.xyz")}, "a.xyz");
    expect_refused({"render", cornell(), "-o", path("a")}, "a");
    expect_refused({"render", cornell(), "-o", folder_.path()}, folder_.path());
    expect_refused({"render", cornell(), "-o", path("a.png"), "--aov", "indirect"}, "expected .exr");
    expect_refused({"render", cornell(), "-o", path("a.hdr"), "--aov", "depth"}, "expected .exr");
    expect_refused({"render", cornell(), "-o", path("a.png"), "--stats", path("none/s.json")}, "s.json");
    expect_refused({"render", cornell(), "-o", path("a.png"), "--trace", folder_.path()}, folder_.path());
}

TEST_F(CommandLine, WithoutOpenGlTheExitCodeIs3) {
    const Outcome result =
        run({"render", cornell(), "-o", path("a.png")}, {"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json"});
    EXPECT_EQ(result.code, 3) << result.err;
    EXPECT_EQ(result.error_lines(), 1) << result.err;
    EXPECT_FALSE(std::ifstream(path("a.png")).is_open());
}

TEST_F(CommandLine, Inspect) {
    const Outcome result = run({"inspect", support::repository_file("assets/lantern-room.glb"), "--plan"});
    EXPECT_EQ(result.code, 0) << result.err;
    for (const char* part : {"door", "lantern-light", "15 cd", "bricks", "64 x 64", "far_sensor", "diagonal",
                             "plan", "environment_maps"}) {
        EXPECT_NE(result.out.find(part), std::string::npos) << part << "\n" << result.out;
    }
}

TEST_F(CommandLine, InspectAsJson) {
    const Outcome result =
        run({"inspect", support::repository_file("assets/lantern-room.glb"), "--plan", "--json"});
    EXPECT_EQ(result.code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    const auto named = [&](const char* list, const std::string& name) {
        for (const auto& thing : json.at(list)) {
            if (thing.at("name") == name) {
                return thing;
            }
        }
        ADD_FAILURE() << "no " << name << " in " << list;
        return nlohmann::json();
    };
    const auto door = named("nodes", "door");
    EXPECT_EQ(door.at("extras").at("door").at("open_angle"), 1.9);
    EXPECT_TRUE(door.at("camera").is_null());
    const auto& mesh = json.at("meshes").at(door.at("meshes").at(0).get<std::size_t>());
    EXPECT_EQ(mesh.at("triangles"), 12);
    EXPECT_NEAR(mesh.at("size").at(0), 0.049, 1e-6);
    EXPECT_TRUE(mesh.at("subdivision").is_null());
    const auto flame = named("nodes", "lantern-light");
    const auto& light = json.at("lights").at(flame.at("light").get<std::size_t>());
    EXPECT_EQ(light.at("type"), "point");
    EXPECT_EQ(light.at("intensity"), 15);
    EXPECT_EQ(light.at("unit"), "cd");
    EXPECT_TRUE(light.at("cone").is_null());
    EXPECT_EQ(json.at("textures").at(0).at("size"), (nlohmann::json{64, 64}));
    EXPECT_GE(json.at("triangles").at("placed"), json.at("triangles").at("stored"));
    EXPECT_GT(json.at("bounds").at("diagonal"), 5);
    EXPECT_TRUE(json.at("skins").empty() && json.at("warnings").empty());
    EXPECT_EQ(json.at("plan").at(0).at("on").type(), nlohmann::json::value_t::boolean);
    EXPECT_TRUE(json.at("plan_note").is_null());

    const Outcome puppet = run({"inspect", support::repository_file("assets/puppet.glb"), "--json"});
    const auto moving = nlohmann::json::parse(puppet.out);
    EXPECT_EQ(moving.at("animations").at(0).at("moves"),
              (nlohmann::json{"translation", "rotation", "weights"}));
    EXPECT_EQ(moving.at("skins").at(0).at("joints").size(), 20u);
    EXPECT_FALSE(moving.contains("plan"));
}

TEST_F(CommandLine, CompareEqual) {
    const std::string a = write("a.exr", 8, 8, 2.5f);
    const Outcome result = run({"compare", a, a, "--json", "--max", "0"});
    EXPECT_EQ(result.code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json.at("relrmse"), 0);
    EXPECT_EQ(json.at("flux"), 1);
    EXPECT_TRUE(json.at("psnr").is_null());
    EXPECT_TRUE(json.at("flip").is_null()) << "not a displayable picture";
    EXPECT_EQ(json.at("hdrflip"), 0);
    EXPECT_NEAR(json.at("ssim"), 1, 1e-6);
    EXPECT_EQ(json.at("channels").size(), 3u);
}

TEST_F(CommandLine, CompareAgainstALimit) {
    const std::string a = write("a.exr", 8, 8, 1.1f), b = write("b.exr", 8, 8, 1.0f);
    EXPECT_EQ(run({"compare", a, b, "--max", "0.11"}).code, 0);
    expect_refused({"compare", a, b, "--max", "0.09"}, "relrmse is 0.1, expected at most 0.09", 1);
    expect_refused({"compare", a, b, "--metric", "flux", "--min", "1.2"},
                   "flux is 1.1, expected at least 1.2", 1);
    EXPECT_EQ(run({"compare", a, b, "--metric", "flux", "--min", "1.05", "--max", "1.15"}).code, 0);
}

TEST_F(CommandLine, CompareWritesAHeatMap) {
    const std::string a = write("a.png", 8, 8, 0.5f), b = write("b.png", 8, 8, 0.25f);
    const Outcome result = run({"compare", a, b, "--metric", "flip", "--heatmap", path("map.png"), "--json"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_GT(nlohmann::json::parse(result.out).at("flip"), 0.05);
    const ImageF map = read_image(path("map.png"));
    EXPECT_EQ(map.width, 8);
    EXPECT_GT(map.at(4, 4, 0), 0);
}

TEST_F(CommandLine, CompareWithinAMask) {
    const std::string a = write("a.exr", 8, 8, 1.5f), b = write("b.exr", 8, 8, 1.0f);
    ImageF mask = read_image(b);
    std::fill(mask.pixels.begin(), mask.pixels.end(), 0.0f);
    write_image(path("empty.png"), mask);
    std::fill(mask.pixels.begin(), mask.pixels.begin() + 3 * 8, 1.0f);
    write_image(path("mask.png"), mask);
    const Outcome result = run({"compare", a, b, "--json", "--mask", path("mask.png"), "--metric", "bias",
                                "--max", "0.51", "--heatmap", path("map.png")});
    EXPECT_EQ(result.code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json.at("valid_pixels"), 8);
    EXPECT_NEAR(json.at("channels").at(2).at("bias"), 0.5, 1e-6);
    const ImageF map = read_image(path("map.png"));
    EXPECT_GT(map.at(3, 0, 0), 0);
    EXPECT_EQ(map.at(3, 1, 0), 0);
    expect_refused({"compare", a, b, "--mask", path("empty.png")}, "empty.png: found no pixel");
    expect_refused({"compare", a, b, "--mask", write("m.png", 8, 9, 1)}, "m.png: found 8 x 9 pixels");
    expect_refused({"compare", a, b, "--mask", path("none.png")}, "none.png");
}

TEST_F(CommandLine, CompareRefusesAReferenceOfAnotherScene) {
    const auto of_scene = [&](const std::string& name, const std::string& scene) {
        ImageF image = read_image(write(name, 8, 8, 1));
        image.metadata["scene"] = scene;
        write_image(path(name), image);
        return path(name);
    };
    const std::string a = of_scene("a.exr", "0123"), b = of_scene("b.exr", "4567"),
                      none = write("n.exr", 8, 8, 1);
    expect_refused({"compare", a, b}, "a.exr: metadata: found scene 0123, expected 4567");
    EXPECT_EQ(run({"compare", a, b, "--any-scene"}).code, 0);
    EXPECT_EQ(run({"compare", a, none}).code, 0);
    EXPECT_EQ(run({"compare", a, a}).code, 0);
}

// A pixel that is no number takes nothing from the picture around it, but breaks every limit.
TEST_F(CommandLine, CompareRepairsPixels) {
    const std::string whole = write("a.exr", 8, 8, 2);
    for (const float value : {NAN, INFINITY, -INFINITY}) {
        ImageF image = read_image(whole);
        image.at(0, 0, 1) = image.at(7, 3, 0) = image.at(7, 3, 2) = value;
        const std::string bad = path("bad.exr");
        write_image(bad, image);
        for (const auto& [a, b] : {std::pair(bad, whole), std::pair(whole, bad)}) {
            const Outcome result = run({"compare", a, b, "--json"});
            EXPECT_EQ(result.code, 0) << result.err;
            EXPECT_EQ(nlohmann::json::parse(result.out).at("max"), 0);
            EXPECT_EQ(result.error_lines(), 1);
            EXPECT_NE(result.err.find("bad.exr: 2 pixels are infinite or no number"), std::string::npos);
            expect_refused({"compare", a, b, "--max", "1"}, "bad.exr: pixel (0, 0) channel 1");
        }
    }
    ImageF image = read_image(whole);
    for (int x = 0; x < 7; ++x) {
        image.at(x, 4, 0) = NAN;
    }
    write_image(path("many.exr"), image);
    expect_refused({"compare", path("many.exr"), whole}, "many.exr: pixel (0, 4) channel 0: found nan");
}

TEST_F(CommandLine, CompareRefusesWhatDoesNotMatch) {
    const std::string a = write("a.exr", 8, 8, 2), b = write("b.exr", 8, 9, 1),
                      nan = write("n.exr", 8, 8, NAN), black = write("black.exr", 8, 8, 0);
    expect_refused({"compare", a, b}, "expected 8 x 9");
    expect_refused({"compare", nan, a}, "n.exr: pixel (0, 0) channel 0: found nan");
    expect_refused({"compare", a, nan}, "n.exr");
    expect_refused({"compare", a, black}, "black.exr");
    expect_refused({"compare", a, path("missing.exr")}, "missing.exr");
    expect_refused({"compare", a, write("text.exr", "not an image")}, "text.exr");
    expect_refused({"compare", a, write("four.png", 8, 8, 1)}, "found linear values");
    expect_refused({"compare", a, a, "--metric", "flip"}, "flip does not apply");
    expect_refused({"compare", a}, "REF");
    expect_refused({"compare", a, a, "--metric", "beauty"}, "beauty");
    expect_refused({"compare", a, a, "--heatmap", path("none/map.png")}, "map.png");
}

TEST_F(CommandLine, WhatIsNoNumberIsRefused) {
    const std::string a = write("a.exr", 8, 8, 2);
    expect_refused({"render", cornell(), "-o", path("a.png"), "--time", "nan"}, "--time");
    expect_refused({"compare", a, a, "--max", "nan"}, "--max");
    expect_refused({"compare", a, a, "--metric", "flux", "--min", "nan"}, "--min");
}

TEST_F(CommandLine, CompareWithNegativeValues) {
    const std::string below = write("below.exr", 8, 8, -1), near = write("near.exr", 8, 8, -2),
                      zero = write("zero.exr", 8, 8, 0);
    expect_refused({"compare", near, below, "--max", "0.5"}, "relrmse is 1, expected at most 0.5", 1);
    expect_refused({"compare", zero, below, "--metric", "hdrflip", "--max", "1"}, "hdrflip does not apply");
}

TEST_F(CommandLine, ATerminalIsTakenAtItsWord) {
    SceneData scene = scene_generator::cornell();
    scene.nodes[0].name = "a\x1b[2J\x07";
    const Outcome result = run({"inspect", write("odd.glb", scene)});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out.find('\x1b'), std::string::npos);
    EXPECT_NE(result.out.find("a\\x1b[2J\\x07"), std::string::npos);
    expect_refused({"render", path("odd.glb"), "-o", path("a.png"), "--camera", "\x1b]0;x"},
                   "found no camera '\\x1b]0;x'");
}

TEST_F(CommandLine, VariantsAndFilesOutside) {
    const std::string head =
        R"({"asset":{"version":"2.0"},"extensions":{"KHR_materials_variants":{"variants":[{"name":"Night"}]}})";
    const std::string file = write("v.gltf", head + "}");
    EXPECT_EQ(run({"inspect", file, "--variant", "Night"}).code, 0);
    expect_refused({"inspect", file, "--variant", "Noon"}, "found no variant 'Noon', expected one of: Night");
    expect_refused({"render", file, "-o", path("a.png"), "--variant", "Noon"}, "found no variant 'Noon'");
    const std::string outside = write(
        "o.gltf",
        head +
            R"(,"buffers":[{"uri":"/etc/passwd","byteLength":1}],"bufferViews":[{"buffer":0,"byteLength":1}]})");
    expect_refused({"inspect", outside}, "(--allow-outside reads it)");
    EXPECT_EQ(run({"inspect", outside, "--allow-outside"}).code, 0);
}

}  // namespace
}  // namespace lanthorn
