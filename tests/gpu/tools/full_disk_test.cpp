// Disks that are full and folders that cannot be written: one line, exit code 2, nothing half-written, and
// what was finished stays.
#include <gtest/gtest.h>

#include <fstream>

#include "lanthorn/assets/image_io.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/refused.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn {
namespace {

using support::FileSizeLimit;
using testing_tools::Outcome;
using Words = std::vector<std::string>;

class FullDisk : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    static Outcome run(const Words& arguments) {
        return testing_tools::run_program(LANTHORN_BINARY, arguments);
    }

    // With files of at most `bytes`: its message, and the folder as it was.
    void expect_too_large(const Words& arguments, const std::string& file, rlim_t bytes = 300) const {
        const auto before = folder_.files();
        const Outcome result = [&] {
            const FileSizeLimit limit(bytes);
            return run(arguments);
        }();
        testing_tools::expect_refusal(result, file + ": cannot be written: File too large");
        EXPECT_EQ(folder_.files(), before) << testing::PrintToString(arguments);
    }
    static Words render(const Words& more, const std::string& size = "24x16") {
        Words all{"render", kScene, "--size", size, "--technique", "path", "--spp", "2"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    inline static const std::string kScene = support::repository_file("assets/cornell.glb");
    testing_tools::TemporaryFolder folder_;
};

TEST_F(FullDisk, EveryFormatOfRenderTellsOfIt) {
    for (const std::string name : {"a.exr", "a.png", "a.hdr"}) {
        std::ofstream(path(name)) << "old";
        expect_too_large(render({"--aov", "albedo", "-o", path(name)}), name);
        EXPECT_EQ(testing_tools::file_bytes(path(name)), "old");
    }
    expect_too_large({"render", kScene, "--technique", "none", "--size", "24x16", "-o", path("b.png")},
                     "b.png");
}

TEST_F(FullDisk, OneFileThatFailsTakesNoOtherWithIt) {
    // The checkpoint (64 bytes a pixel) and the normals (12, compressed) do not fit, the albedo does.
    const Words command = render({"-o", path("a.exr"), "--aov", "normal", "--aov", "albedo", "--checkpoint",
                                  path("sums"), "--aov", "indirect", "--set", "gi.bounces=1"});
    ASSERT_EQ(run(command).code, 0);
    const auto size = [&](const std::string& name) { return testing_tools::file_bytes(path(name)).size(); };
    const std::size_t albedo = size("a-albedo.exr");
    ASSERT_GT(size("a-normal.exr"), albedo);
    ASSERT_GT(size("sums"), albedo);
    for (const auto& name : folder_.files()) {
        std::filesystem::remove(path(name));
    }
    const Outcome result = [&] {
        const FileSizeLimit limit(albedo);
        return run(command);
    }();
    testing_tools::expect_refusal(result, "sums: cannot be written: File too large");
    EXPECT_EQ(folder_.files(), Words{"a-albedo.exr"});
    EXPECT_EQ(read_image(path("a-albedo.exr")).width, 24);
}

TEST_F(FullDisk, StatsTraceAndHeatMap) {
    const std::string image = path("a.png");
    ASSERT_EQ(run(render({"--aov", "albedo", "-o", image})).code, 0);
    const std::size_t bytes = testing_tools::file_bytes(image).size();
    expect_too_large(render({"--aov", "albedo", "-o", image, "--stats", path("s.json")}), "s.json", bytes);

    ASSERT_EQ(run(render({"--aov", "albedo", "-o", path("b.exr")}, "64x48")).code, 0);
    ASSERT_EQ(run(render({"--aov", "direct", "-o", path("c.exr")}, "64x48")).code, 0);
    expect_too_large({"compare", path("b.exr"), path("c.exr"), "--heatmap", path("h.png")}, "h.png");
}

TEST_F(FullDisk, StandardOutput) {
    for (const Words& command :
         std::vector<Words>{{"--help"},
                            {"inspect", kScene},
                            {"render", "--list-settings"},
                            {"measure", "energy", kScene, "--preset", "low", "--json"}}) {
        Words words{"-c", "exec \"$0\" \"$@\" > /dev/full", LANTHORN_BINARY};
        words.insert(words.end(), command.begin(), command.end());
        testing_tools::expect_refusal(testing_tools::run_program("/bin/sh", words),
                                      "standard output: cannot be written: No space left on device");
    }
}

TEST_F(FullDisk, TradeKeepsWhatIsFinished) {
    const auto trade = [&](const std::string& techniques) {
        return Words{"trade",
                     kScene,
                     "-o",
                     path("out"),
                     "--technique",
                     techniques,
                     "--presets-only",
                     "--preset",
                     "low",
                     "--size",
                     "32x24",
                     "--frames",
                     "1",
                     "--warmup",
                     "0",
                     "--reference-spp",
                     "2"};
    };
    ASSERT_EQ(run(trade("none")).code, 0);
    const std::string csv = testing_tools::file_bytes(path("out/trade.csv"));
    const auto points = [&] { return testing_tools::files_in(path("out/points")); };
    const Words finished = points();
    ASSERT_EQ(finished.size(), 2u) << "figures and picture";

    const Outcome full = [&] {
        const FileSizeLimit limit(300);
        return run(trade("none,emc"));
    }();
    testing_tools::expect_refusal(full, "points");
    EXPECT_NE(full.err.find("cannot be written: File too large"), std::string::npos) << full.err;
    EXPECT_EQ(points(), finished);
    EXPECT_EQ(testing_tools::file_bytes(path("out/trade.csv")), csv);

    EXPECT_EQ(run(trade("none,emc")).code, 0) << "the same command goes on";
    EXPECT_EQ(points().size(), 8u) << "none, both final stages of emc, and the paper's own way";

    // The points are all there, the page does not fit.
    std::filesystem::remove(path("out/trade.html"));
    const Outcome page = [&] {
        const FileSizeLimit limit(testing_tools::file_bytes(path("out/trade.svg")).size());
        return run(trade("none,emc"));
    }();
    testing_tools::expect_refusal(page, "trade.html: cannot be written: File too large");
    EXPECT_EQ(points().size(), 8u);
}

// A file system of 64 kB of its own: no space is left on it, then it is read-only.
TEST_F(FullDisk, ASmallFileSystem) {
    const std::string script =
        "mount -t tmpfs -o size=64k none \"$1\" || exit 77; cd \"$1\"\n"
        "\"$0\" render \"$2\" --technique path --spp 1 --size 128x128 --aov indirect -o a.exr; echo $?; ls "
        "-A\n"
        "mount -o remount,ro \"$1\" || exit 77\n"
        "\"$0\" render \"$2\" --technique path --spp 1 --size 8x8 --aov normal -o b.exr; echo $?; ls -A\n";
    const Outcome result = testing_tools::run_program(
        "/usr/bin/unshare", {"-rm", "sh", "-c", script, LANTHORN_BINARY, folder_.path(), kScene});
    if (result.code != 0) {
        GTEST_SKIP() << "no file system can be mounted here: " << result.err;
    }
    EXPECT_EQ(
        result.out,
        "path: diffuse transport, all bounces, as irradiance is measured; path.transport=full is all\n2\n2\n")
        << "exit codes, and no files";
    EXPECT_EQ(result.err,
              "lanthorn: a.exr: cannot be written: No space left on device\n"
              "lanthorn: b.exr: cannot be written: Read-only file system\n");
}

TEST_F(FullDisk, NoSuchFolder) {
    const std::string lost = path("none/a.exr");
    for (const Words& command :
         std::vector<Words>{render({"-o", lost}),
                            render({"-o", path("a.exr"), "--checkpoint", path("none/sums")}),
                            render({"-o", path("a.exr"), "--stats", path("none/s.json")}),
                            {"compare", "a.exr", "b.exr", "--heatmap", path("none/h.png")},
                            {"trade", kScene, "-o", "/dev/null/out"}}) {
        testing_tools::expect_refusal(run(command),
                                      command.front() == "trade" ? "/dev/null/out" : "there is no folder");
    }
    EXPECT_TRUE(folder_.files().empty());
}

}  // namespace
}  // namespace lanthorn
