// The real `lanthorn render`: what it writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "lanthorn/assets/image_io.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"
#include "tools/scene_generator/builder.h"
#include "tools/scene_generator/glb_bytes.h"

namespace lanthorn {
namespace {

using nlohmann::json;
using testing_tools::file_bytes;
using testing_tools::Outcome;

class RenderCommand : public testing::Test {
  protected:
    // Renders assets/SCENE small and expects success without a word.
    void render(const std::string& scene, std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"render", support::repository_file("assets/" + scene)});
        arguments.insert(arguments.end(), {"--size", "48x32", "--set", "gi.photons=2000", "--set",
                                           "gi.emc.resolution=32", "--set", "gi.emc.candidates=8"});
        const Outcome result = testing_tools::run_program(LANTHORN_BINARY, arguments);
        ASSERT_EQ(result.code, 0) << result.err;
        ASSERT_EQ(result.err, "") << "no progress bar and no warning";
        // But for what light it is of where that is not the default's.
        ASSERT_TRUE(result.out.empty() || result.out.starts_with("emc: light of ")) << result.out;
        ASSERT_LE(std::ranges::count(result.out, '\n'), 1) << result.out;
    }
    std::string path(const std::string& name) const { return folder_.path(name); }

    static double mean(const ImageF& image, int channel, int x_from, int x_to) {
        double sum = 0;
        for (int y = 0; y < image.height; ++y) {
            for (int x = x_from; x < x_to; ++x) {
                sum += image.at(x, y, channel);
            }
        }
        return sum / (image.height * (x_to - x_from));
    }

    testing_tools::TemporaryFolder folder_;
    std::set<std::string> scenes_;  // as the pictures' metadata name them
};

TEST_F(RenderCommand, ASignalEndsItAfterTheFrame) {
    const Outcome result = testing_tools::run_program(
        "/usr/bin/timeout", {"--preserve-status", "--signal", "INT", "4", LANTHORN_BINARY, "render",
                             support::repository_file("assets/cornell.glb"), "--size", "48x32", "--set",
                             "gi.photons=2000", "--warmup", "1000000", "-o", path("a.png")});
    EXPECT_EQ(result.code, 130) << result.err;
    EXPECT_NE(result.err.find("stopped by SIGINT"), std::string::npos) << result.err;
    EXPECT_EQ(read_image(path("a.png")).metadata["unfinished"], "stopped by SIGINT");
}

TEST_F(RenderCommand, APictureThatOpenGlCannotMakeIsRefusedBeforeItIsBegun) {
    const Outcome result =
        testing_tools::run_program(LANTHORN_BINARY, {"render", support::repository_file("assets/cornell.glb"),
                                                     "--size", "16384x16384", "-o", path("a.png")});
    if (result.code == 0) {
        GTEST_SKIP() << "this OpenGL makes it";
    }
    EXPECT_EQ(result.code, 2) << result.err;
    EXPECT_NE(result.err.find("--size: found 16384x16384, expected fewer pixels"), std::string::npos)
        << result.err;
}

TEST_F(RenderCommand, OneAovGoesToTheNameGiven) {
    render("cornell.glb", {"-o", path("a.exr"), "--aov", "indirect"});
    EXPECT_EQ(folder_.files(), (std::vector<std::string>{"a.exr"}));
    const ImageF image = read_image(path("a.exr"));
    EXPECT_EQ(image.width, 48);
    EXPECT_EQ(image.height, 32);
    EXPECT_EQ(image.channels, 3);
    EXPECT_GT(mean(image, 0, 0, 48), 1) << "lux";
}

TEST_F(RenderCommand, SeveralAovsGetTheirNamesBeforeTheEnding) {
    render("cornell.glb", {"-o", path("a.b.exr"), "--aov", "albedo", "--aov", "normal", "--aov", "depth",
                           "--aov", "direct", "--aov", "final"});
    EXPECT_EQ(folder_.files(), (std::vector<std::string>{"a.b-albedo.exr", "a.b-depth.exr", "a.b-direct.exr",
                                                         "a.b-final.exr", "a.b-normal.exr"}));
    const ImageF albedo = read_image(path("a.b-albedo.exr"));
    EXPECT_GT(mean(albedo, 0, 8, 14), mean(albedo, 1, 8, 14)) << "red on the left";
    EXPECT_GT(mean(albedo, 1, 34, 40), mean(albedo, 0, 34, 40)) << "green on the right";
    const ImageF depth = read_image(path("a.b-depth.exr"));
    EXPECT_EQ(depth.channels, 1);
    EXPECT_NEAR(depth.at(24, 12, 0), 1.36f, 0.1f) << "metres to the back wall";
    const ImageF normal = read_image(path("a.b-normal.exr"));
    EXPECT_NEAR(normal.at(24, 8, 2), 1, 0.02f) << "the back wall faces the camera";
}

TEST_F(RenderCommand, DebugViewsStandBesideAovs) {
    render("cornell.glb", {"-o", path("a.exr"), "--aov", "maps", "--aov", "indirect", "--aov", "coverage"});
    EXPECT_EQ(folder_.files(), (std::vector<std::string>{"a-coverage.exr", "a-indirect.exr", "a-maps.exr"}));
    const ImageF maps = read_image(path("a-maps.exr"));
    EXPECT_EQ(maps.width, 6 * 32);
    EXPECT_EQ(maps.height % 32, 0);  // a row a map
    EXPECT_TRUE(maps.height > 0 && maps.height <= 8 * 32) << maps.height;
    EXPECT_EQ(maps.metadata.at("view"), "maps");
    const ImageF coverage = read_image(path("a-coverage.exr"));
    EXPECT_EQ(coverage.width, 48);
    EXPECT_LE(*std::ranges::max_element(coverage.pixels), 8.0f);
    render("cornell.glb", {"-o", path("b.png"), "--aov", "coverage"});
    EXPECT_GT(mean(read_image(path("b.png")), 0, 0, 48), 0.1);
}

TEST_F(RenderCommand, ADebugViewOfAnotherTechniqueIsRefused) {
    const auto refused = [&](std::vector<std::string> arguments, const std::string& word) {
        arguments.insert(arguments.begin(), {"render", support::repository_file("assets/cornell.glb"),
                                             "--size", "16x16", "-o", path("a.exr")});
        const Outcome result = testing_tools::run_program(LANTHORN_BINARY, arguments);
        EXPECT_EQ(result.code, 2) << word;
        EXPECT_EQ(result.error_lines(), 1) << result.err;
        EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
        EXPECT_TRUE(folder_.files().empty());
    };
    refused({"--technique", "drm", "--aov", "coverage"}, "of drm radiance-map, samples");
    refused({"--technique", "none", "--aov", "indirect", "--aov", "maps"}, "expected one of final");
    refused({"--set", "gi.emc.final=splat", "--aov", "lit-texels"}, "shows nothing");
    refused({"--technique", "path", "--time-limit", "1", "--aov", "variance"}, "--time-limit");
    const Outcome listed = testing_tools::run_program(LANTHORN_BINARY, {"render", "--list-aovs"});
    EXPECT_EQ(listed.code, 0);
    EXPECT_NE(listed.out.find("coverage"), std::string::npos);
}

TEST_F(RenderCommand, PngIsTheFinalPictureDisplayEncoded) {
    render("cornell.glb", {"-o", path("a.png")});
    render("cornell.glb", {"-o", path("a.exr")});
    const ImageF png = read_image(path("a.png")), exr = read_image(path("a.exr"));
    for (std::size_t i = 0; i < png.pixels.size(); ++i) {
        const float v = png.pixels[i];
        const float linear = v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
        ASSERT_NEAR(exr.pixels[i], linear, 1e-3f);
    }
}

TEST_F(RenderCommand, SameSeedSameBytes) {
    render("two-rooms.glb", {"-o", path("a.exr"), "--aov", "indirect", "--seed", "3"});
    render("two-rooms.glb", {"-o", path("b.exr"), "--aov", "indirect", "--seed", "3"});
    render("two-rooms.glb", {"-o", path("c.exr"), "--aov", "indirect", "--seed", "4"});
    EXPECT_EQ(read_image(path("a.exr")).pixels, read_image(path("b.exr")).pixels);
    EXPECT_NE(read_image(path("a.exr")).pixels, read_image(path("c.exr")).pixels);
}

TEST_F(RenderCommand, CameraByNameAndNumber) {
    render("two-rooms.glb", {"-o", path("a.exr"), "--aov", "depth", "--camera", "dark"});
    render("two-rooms.glb", {"-o", path("b.exr"), "--aov", "depth", "--camera", "1"});
    render("two-rooms.glb", {"-o", path("c.exr"), "--aov", "depth"});
    render("two-rooms.glb", {"-o", path("d.exr"), "--aov", "depth", "--camera", "auto"});
    const auto pixels = [&](const char* name) { return read_image(path(name)).pixels; };
    EXPECT_EQ(pixels("a.exr"), pixels("b.exr"));
    EXPECT_NE(pixels("a.exr"), pixels("c.exr"));
    EXPECT_NE(pixels("a.exr"), pixels("d.exr"));
}

TEST_F(RenderCommand, WithoutATechniqueThereIsNoIndirectLight) {
    render("cornell.glb", {"-o", path("a.exr"), "--aov", "indirect", "--technique", "none"});
    for (const float v : read_image(path("a.exr")).pixels) {
        ASSERT_EQ(v, 0);
    }
}

TEST_F(RenderCommand, StatisticsHaveWhatTheManualPromises) {
    render("cornell.glb", {"-o", path("a.png"), "--preset", "high", "--frames", "3", "--warmup", "1", "--set",
                           "gi.emc.final=splat", "--stats", path("s.json"), "--trace", path("t.json")});
    const json stats = json::parse(file_bytes(path("s.json")));
    EXPECT_EQ(stats.at("technique"), "emc");
    EXPECT_EQ(stats.at("preset"), "high");
    EXPECT_EQ(stats.at("size"), (json{48, 32}));
    EXPECT_EQ(stats.at("frames"), 3);
    EXPECT_LE(stats.at("ms").at("median"), stats.at("ms").at("p95"));
    EXPECT_GT(stats.at("ms").at("cpu"), 0);
    for (const char* pass : {"gbuffer", "light_maps", "gi", "direct", "composite"}) {
        EXPECT_GE(stats.at("passes").at(pass).at("median"), 0) << pass;
        EXPECT_GT(stats.at("passes").at(pass).at("cpu"), 0) << pass;
    }
    for (const char* system : {"transforms", "extract", "upload", "gbuffer", "gi.indirect", "composite"}) {
        EXPECT_GT(stats.at("systems").at(system).at("p95"), 0) << system;
    }
    EXPECT_EQ(stats.at("photons").at("emitted"), 2000);
    EXPECT_GT(stats.at("photons").at("stored"), 0);
    EXPECT_TRUE(stats.at("photons").at("lost").is_number());
    EXPECT_EQ(stats.at("bounces"), 3) << "the high preset's";
    EXPECT_EQ(stats.at("emc").at("candidates"), 8);
    EXPECT_EQ(stats.at("emc").at("resolution"), 32);
    EXPECT_GT(stats.at("emc").at("k"), 0);
    EXPECT_GT(stats.at("emc").at("coverage"), 0.5);
    EXPECT_EQ(stats.at("emc").at("updates"), 1) << "none while nothing moves";
    ASSERT_FALSE(stats.at("plan").empty());
    for (const json& entry : stats.at("plan")) {
        EXPECT_TRUE(entry.at("on").is_boolean());
        EXPECT_NE(entry.at("pass"), "");
        EXPECT_NE(entry.at("why"), "");
    }
    EXPECT_GT(stats.at("memory").at("gpu_mb"), 0);
    EXPECT_GT(stats.at("memory").at("rss_mb"), 0);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they take memory of their own
    EXPECT_LT(stats.at("memory").at("rss_mb"), 600);
#endif
    EXPECT_EQ(stats.at("nan_count"), 0);
    for (const char* key : {"vendor", "renderer", "version"}) {
        EXPECT_NE(stats.at("gl").at(key), "") << key;
    }
    for (const char* key : {"version", "commit", "type"}) {
        EXPECT_TRUE(stats.at("build").at(key).is_string()) << key;
    }

    const json trace = json::parse(file_bytes(path("t.json")));
    int frames = 0;
    for (const json& event : trace.at("traceEvents")) {
        EXPECT_GE(event.at("dur"), 0);
        frames += event.at("name").get<std::string>().rfind("frame ", 0) == 0;
    }
    EXPECT_EQ(frames, 3);
}

// A cube of half a metre to each side as the cage of a rounded shape, and a lamp, both so far from the
// camera.
SceneData cage_seen_from(double metres) {
    scene_generator::Builder b;
    Mesh cube;
    for (std::uint32_t i = 0; i < 8; ++i) {
        Vertex v;
        v.position = vec3(i & 1, i >> 1 & 1, i >> 2) - 0.5f;
        v.normal = glm::normalize(v.position);
        cube.bounds.add(v.position);
        cube.vertices.push_back(v);
    }
    cube.cage = SubdivisionCage{};
    cube.cage->level = 4;
    cube.cage->face_sizes.assign(6, 4);
    for (const std::array<std::uint32_t, 4>& f : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                                                  {4, 5, 7, 6},
                                                  {0, 1, 5, 4},
                                                  {2, 6, 7, 3},
                                                  {0, 4, 6, 2},
                                                  {1, 3, 7, 5}}) {
        cube.indices.insert(cube.indices.end(), {f[0], f[1], f[2], f[0], f[2], f[3]});
    }
    cube.material = b.matte("grey", vec3(0.5f));
    b.scene.meshes.push_back(cube);
    b.scene.nodes[b.node("cage", {})].meshes = {0};
    const dvec3 eye(0, 0, metres);
    b.camera("view", scene_generator::looking(eye, dvec3(0)), 0.8f);
    Light lamp;
    lamp.intensity = 1000;
    b.light("lamp", scene_generator::at(eye), lamp);
    return std::move(b.scene);
}

TEST_F(RenderCommand, SubdivisionSurfacesAreAsFineAsTheCameraCanTell) {
    const auto triangles = [&](double metres, const char* frames, const std::string& setting) {
        std::ofstream(path("cage.glb"), std::ios::binary)
            << scene_generator::glb_bytes(cage_seen_from(metres));
        const Outcome result = testing_tools::run_program(
            LANTHORN_BINARY, {"render", path("cage.glb"), "-o", path("cage.png"), "--technique", "none",
                              "--size", "96x96", "--frames", frames, "--stats", path("cage.json"), "--set",
                              "render.shadow.resolution=64", "--set", "render.adaptive_detail=" + setting});
        EXPECT_EQ(result.code, 0) << result.err;
        const json stats = json::parse(file_bytes(path("cage.json")));
        scenes_.insert(stats.at("images").at(0).at("scene").get<std::string>());
        return stats.at("triangles").get<int>();
    };
    const int all = 6 * 2 * 256;
    EXPECT_EQ(triangles(0.8, "3", "true"), all) << "in front of one's nose";
    EXPECT_EQ(triangles(60, "3", "true"), 6 * 2 * 4) << "two pixels";
    const int between = triangles(4, "3", "true");
    EXPECT_LT(between, all);
    EXPECT_GT(between, 6 * 2 * 4);
    scenes_.clear();
    EXPECT_EQ(triangles(60, "3", "false"), all);
    EXPECT_EQ(triangles(60, "1", "true"), all) << "nobody has looked yet";
    EXPECT_EQ(triangles(60, "3", "true"), 6 * 2 * 4);
    EXPECT_EQ(scenes_.size(), 1u) << "however fine, it is the same scene to compare with";
}

TEST_F(RenderCommand, RefusedRunsLeaveAnOldPictureAlone) {
    render("cornell.glb", {"-o", path("a.png")});
    const std::string before = file_bytes(path("a.png"));
    const Outcome result =
        testing_tools::run_program(LANTHORN_BINARY, {"render", path("missing.glb"), "-o", path("a.png")});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(file_bytes(path("a.png")), before);
    EXPECT_EQ(folder_.files(), (std::vector<std::string>{"a.png"}));
}

}  // namespace
}  // namespace lanthorn
