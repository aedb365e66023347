// `lanthorn render --technique path` as a user runs it.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lanthorn/assets/image_io.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/refused.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn {
namespace {

using testing_tools::Outcome;

// No OpenGL at all.
const std::vector<std::string> kNoGl{"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json"};

class PathCommand : public testing::Test {
  protected:
    Outcome run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"render", support::repository_file("assets/cornell.glb"),
                                             "--size", "24x16", "--technique", "path"});
        return testing_tools::run_program(LANTHORN_BINARY, arguments, kNoGl);
    }
    void done(const std::vector<std::string>& arguments) const {
        const Outcome result = run(arguments);
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        EXPECT_EQ(result.out.find('\n') == std::string::npos ? "" : result.out.substr(0, 24),
                  result.out.empty() ? "" : "path: diffuse transport,")
            << result.out;
        EXPECT_LE(std::ranges::count(result.out, '\n'), 1);
    }
    void refused(const std::vector<std::string>& arguments, const std::string& part, int code = 2) const {
        const auto before = folder_.files();
        testing_tools::expect_refusal(run(arguments), part, arguments, code);
        EXPECT_EQ(folder_.files(), before);
    }
    std::string path(const std::string& name) const { return folder_.path(name); }
    testing_tools::TemporaryFolder folder_;
};

TEST_F(PathCommand, WritesItsNoiseBesideTheImage) {
    done({"-o", path("a.exr"), "--aov", "indirect", "--spp", "8", "--stats", path("s.json")});
    const ImageF image = read_image(path("a.exr"));
    EXPECT_EQ(image.channels, 3);
    const double noise = std::stod(image.metadata.at("noise"));
    EXPECT_GT(noise, 0.05);
    EXPECT_LT(noise, 2);
    EXPECT_EQ(image.metadata.at("spp"), "8");
    EXPECT_EQ(image.metadata.at("technique"), "path");
    EXPECT_EQ(image.metadata.at("transport"), "diffuse");
    EXPECT_EQ(image.metadata.at("bounces"), "unlimited");
    EXPECT_EQ(image.metadata.at("scene").size(), 16u);
    const auto stats = nlohmann::json::parse(testing_tools::file_bytes(path("s.json")));
    EXPECT_EQ(stats.at("technique"), "path");
    EXPECT_EQ(stats.at("images").at(0).at("spp"), "8");
}

// The picture is what materials say; irradiance, which is measured, leaves glass opaque.
TEST_F(PathCommand, ShowsGlassUnasked) {
    const auto middle = [&](const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> words{"render",      support::repository_file("assets/glass-ball.glb"),
                                       "--size",      "24x24",
                                       "--technique", "path",
                                       "--spp",       "16",
                                       "--aov",       "radiance",
                                       "-o",          path(name)};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(testing_tools::run_program(LANTHORN_BINARY, words, kNoGl).code, 0);
        const ImageF image = read_image(path(name));
        float sum = 0;
        for (int y = 11; y < 14; ++y) {
            for (int x = 12; x < 15; ++x) {
                sum += image.at(x, y, 1);
            }
        }
        return std::pair(sum, image.metadata.at("transport") + ' ' + image.metadata.at("bounces"));
    };
    const auto [shown, told] = middle("a.exr", {});
    const auto [opaque, told_opaque] = middle("b.exr", {"--set", "path.transport=diffuse"});
    EXPECT_GT(shown, 20 * opaque);
    EXPECT_GT(shown, 0);
    EXPECT_EQ(told, "full unlimited");
    EXPECT_EQ(told_opaque, "diffuse 2");
    const Outcome measured = run({"-o", path("c.exr"), "--aov", "indirect", "--spp", "1"});
    EXPECT_EQ(measured.out.rfind("path: diffuse transport, all bounces, as irradiance is measured", 0), 0u)
        << measured.out;
}

TEST_F(PathCommand, SeveralAovsAtOnce) {
    done({"-o", path("a.exr"), "--set", "path.spp=2", "--aov", "indirect", "--aov", "direct", "--aov",
          "radiance", "--aov", "albedo", "--aov", "normal", "--aov", "depth"});
    EXPECT_EQ(folder_.files().size(), 6u);
    EXPECT_EQ(read_image(path("a-depth.exr")).channels, 1);
    EXPECT_EQ(read_image(path("a-depth.exr")).metadata.count("noise"), 0u) << "it has none";
    EXPECT_NEAR(read_image(path("a-normal.exr")).at(12, 4, 2), 1, 0.02f) << "the back wall faces the camera";
}

TEST_F(PathCommand, IsASettingLikeEveryTechnique) {
    done({"-o", path("a.exr"), "--aov", "indirect", "--spp", "2"});
    const std::vector<std::string> setting{"render", support::repository_file("assets/cornell.glb"),
                                           "--size", "24x16",
                                           "-o",     path("b.exr"),
                                           "--aov",  "indirect",
                                           "--spp",  "2",
                                           "--set",  "gi.technique=path"};
    EXPECT_EQ(testing_tools::run_program(LANTHORN_BINARY, setting, kNoGl).code, 0);
    EXPECT_EQ(read_image(path("a.exr")).pixels, read_image(path("b.exr")).pixels);
}

TEST_F(PathCommand, GoesOnFromACheckpoint) {
    done({"-o", path("a.exr"), "--aov", "indirect", "--spp", "6"});
    done({"-o", path("b.exr"), "--aov", "indirect", "--spp", "2", "--checkpoint", path("sums")});
    done({"-o", path("b.exr"), "--aov", "indirect", "--spp", "6", "--checkpoint", path("sums")});
    EXPECT_EQ(read_image(path("a.exr")).pixels, read_image(path("b.exr")).pixels);
    refused({"-o", path("b.exr"), "--aov", "indirect", "--seed", "7", "--checkpoint", path("sums")},
            "sums: found");
    refused({"-o", path("b.exr"), "--aov", "indirect", "--checkpoint", path("a.exr")},
            "a.exr: found something else");
}

TEST_F(PathCommand, RefusesADamagedCheckpoint) {
    done({"-o", path("a.exr"), "--aov", "indirect", "--spp", "2", "--checkpoint", path("sums")});
    std::string bytes = testing_tools::file_bytes(path("sums"));
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    std::ofstream(path("sums"), std::ios::binary) << bytes;
    refused({"-o", path("b.exr"), "--aov", "indirect", "--spp", "4", "--checkpoint", path("sums")},
            "sums: found a damaged checkpoint");
}

// What a signal ends tells so by its exit code and leaves what it has.
TEST_F(PathCommand, ASignalLeavesAPictureMarkedAsUnfinished) {
    const Outcome result = testing_tools::run_program(
        "/usr/bin/timeout",
        {"--preserve-status", "--signal", "TERM", "4", LANTHORN_BINARY, "render",
         support::repository_file("assets/cornell.glb"), "--size", "24x16", "--technique", "path", "--aov",
         "indirect", "--spp", "1000000", "-o", path("a.exr"), "--checkpoint", path("sums")},
        kNoGl);
    EXPECT_EQ(result.code, 143) << result.err;
    EXPECT_NE(result.err.find("stopped by SIGTERM"), std::string::npos) << result.err;
    EXPECT_EQ(read_image(path("a.exr")).metadata["unfinished"], "stopped by SIGTERM");
    EXPECT_FALSE(testing_tools::file_bytes(path("sums")).empty());
}

TEST_F(PathCommand, StopsAtItsLimits) {
    done({"-o", path("a.exr"), "--aov", "indirect", "--time-limit", "0.05"});
    EXPECT_GE(std::stoi(read_image(path("a.exr")).metadata.at("spp")), 1);
    done({"-o", path("b.exr"), "--aov", "indirect", "--target-noise", "0.3"});
    EXPECT_LE(std::stod(read_image(path("b.exr")).metadata.at("noise")), 0.3);
}

TEST_F(PathCommand, RefusesWhatMakesNoSense) {
    refused({"-o", path("a.exr"), "--spp", "0"}, "path.spp");
    refused({"-o", path("a.exr"), "--time-limit", "-1"}, "path.time_limit");
    refused({"-o", path("a.exr"), "--target-noise", "nan"}, "path.target_noise");
    refused({"-o", path("a.exr"), "--set", "path.transport=magic"}, "diffuse");
    refused({"-o", path("a.exr"), "--spp", "1", "--checkpoint", path("none/sums")}, "sums");
    refused({"-o", path("a.exr"), "--spp", "1", "--technique", "emc"}, "--technique");
    refused({"-o", path("a.png"), "--spp", "1"}, "", 3);  // `final` is exposed by OpenGL
}

TEST_F(PathCommand, ItsOptionsNeedIt) {
    const Outcome result = testing_tools::run_program(
        LANTHORN_BINARY,
        {"render", support::repository_file("assets/cornell.glb"), "-o", path("a.exr"), "--spp", "4"}, kNoGl);
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find("--technique path"), std::string::npos);
}

// By pieces that other processes trace, the picture is the same to the bit.
TEST_F(PathCommand, TracesInPieces) {
    const std::vector<std::string> picture = {"--aov",  "indirect", "--aov",  "radiance",
                                              "--aov",  "depth",    "--spp",  "70",
                                              "--seed", "3",        "--pose", "0,1,3.2,0,-4,50"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.end(), picture.begin(), picture.end());
        return more;
    };
    done(with({"-o", path("whole.exr")}));
    done(with({"-o", path("pieces.exr"), "--executor", "local", "--jobs", "2", "--pieces", "5"}));
    for (const std::string aov : {"indirect", "radiance", "depth"}) {
        const ImageF whole = read_image(path("whole-" + aov + ".exr")),
                     pieces = read_image(path("pieces-" + aov + ".exr"));
        EXPECT_EQ(pieces.pixels, whole.pixels) << aov;
        for (const auto& [key, value] : whole.metadata) {
            EXPECT_TRUE(key == "seconds" || pieces.metadata.at(key) == value) << aov << ": " << key;
        }
    }
    EXPECT_EQ(folder_.files().size(), 6u);  // no piece is left behind
}

TEST_F(PathCommand, RefusesPiecesOfWhatHasNone) {
    const std::vector<std::string> to{"-o", path("a.exr"), "--jobs", "2"};
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = to;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    refused(with({"--technique", "emc"}), "--technique");  // twice
    refused(with({"--time-limit", "1"}), "expected a number of samples alone");
    refused(with({"--target-noise", "0.1"}), "expected a number of samples alone");
    refused(with({"--checkpoint", path("sums")}), "expected a number of samples alone");
    refused({"-o", path("a.exr"), "--pieces", "4"}, "--pieces: expected --executor or --jobs");
    refused(with({"--executor", "grid"}), "--executor");
    for (const char* piece :
         {"0:1:0", "0:1:0:1:", "0:0:0:1", "-1:1:0:1", "0:65:0:1", "0:1:16:1", "0:1:0:17"}) {
        refused({"-o", path("a.sums"), "--spp", "64", "--piece", piece},
                "expected FIRST:SAMPLES:TOP:ROWS within 64 samples and 16 rows");
    }
}

}  // namespace
}  // namespace lanthorn
