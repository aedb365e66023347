// Any number of threads, interruptions and passes gives the same bits; the noise that is claimed is the noise
// there is.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "lanthorn/core/error.h"
#include "tests/unit/reference/scenes.h"

namespace lanthorn::reference::test {
namespace {

// A lamp above a box in a corner: both kinds of light, hard and soft shadows, colours.
FrameScene corner() {
    return scene_of(
        {quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, 0), quad({-1, 0, -1}, {2, 0, 0}, {0, 2, 0}, 1),
         sphere({0.3f, 0.4f, -0.2f}, 0.4f, 3, false, 2),
         quad({-0.3f, 1.9f, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f}, 3)},
        {lambertian(vec3(0.7f)), lambertian({0.8f, 0.2f, 0.1f}), lambertian(vec3(0.5f)), lamp(vec3(50))},
        {point_light({-0.6f, 1, 0.5f}, 5)}, vec3(0, 1, 3), vec3(0, 0.7f, 0));
}

const PathParts kAll{true, true, true};

std::vector<float> indirect(const PathSettings& settings, ivec2 size = ivec2(33, 21)) {
    const FrameScene scene = corner();
    PathTracer tracer(scene, size, settings, kAll);
    tracer.render({});
    return tracer.image(PathAov::indirect);
}

class Progressive : public testing::Test {
  protected:
    Progressive() { std::filesystem::create_directories(folder_); }
    ~Progressive() override { std::filesystem::remove_all(folder_); }
    const std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("lanthorn-reference-" + std::to_string(getpid()));
    const std::filesystem::path file_ = folder_ / "sums";
};

TEST_F(Progressive, ThreadsDoNotMatter) {
    PathSettings settings;
    settings.spp = 9;
    settings.threads = 1;
    const std::vector<float> one = indirect(settings);
    for (const int threads : {2, 3, 8}) {
        settings.threads = threads;
        EXPECT_EQ(indirect(settings), one) << threads;
    }
    settings.seed = 2;
    EXPECT_NE(indirect(settings), one);
}

// A picture traced in pieces, as a farm does: other bands, another order, other numbers of threads.
TEST_F(Progressive, PiecesAddUpToTheSameBits) {
    const ivec2 size(33, 21);
    const FrameScene scene = corner();
    PathSettings settings;
    settings.spp = 150;  // two blocks and a part of one
    settings.antialias = true;
    PathTracer whole(scene, size, settings, kAll);
    whole.render({});
    for (const int bands : {1, 4, 100}) {
        const std::vector<PathPiece> pieces = path_pieces(size, settings.spp, bands);
        EXPECT_EQ(pieces.size(), 3u * static_cast<unsigned>(std::min(bands, size.y)));
        std::vector<std::filesystem::path> files;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            files.push_back(folder_ / std::to_string(i));
        }
        for (std::size_t i = pieces.size(); i-- > 0;) {
            settings.threads = 1 + static_cast<int>(i % 3);
            PathTracer one(scene, size, settings, kAll);
            EXPECT_TRUE(one.trace_piece(pieces[i], files[i], {}));
        }
        PathTracer sum(scene, size, settings, kAll);
        EXPECT_TRUE(sum.has_piece(pieces[0], files[0]));
        EXPECT_FALSE(sum.has_piece(pieces[0], files[1]));
        sum.add_up(pieces, files);
        for (const PathAov aov : {PathAov::indirect, PathAov::direct, PathAov::radiance}) {
            EXPECT_EQ(sum.image(aov), whole.image(aov)) << bands;
            EXPECT_EQ(sum.noise(aov), whole.noise(aov)) << bands;
            EXPECT_EQ(sum.description(aov), whole.description(aov)) << bands;
        }
        // And it goes on from there.
        settings.spp = 170;
        PathTracer longer(scene, size, settings, kAll);
        sum.save(file_);
        longer.resume(file_);
        longer.render({});
        PathTracer at_once(scene, size, settings, kAll);
        at_once.render({});
        EXPECT_EQ(longer.image(PathAov::indirect), at_once.image(PathAov::indirect));
        settings.spp = 150;
    }
}

TEST_F(Progressive, PiecesOfAnotherPictureAreRefused) {
    const ivec2 size(8, 8);
    const FrameScene scene = corner();
    PathSettings settings;
    settings.spp = 10;
    PathTracer tracer(scene, size, settings, kAll);
    const std::vector<PathPiece> pieces = path_pieces(size, settings.spp, 1);
    EXPECT_FALSE(tracer.has_piece(pieces[0], file_));
    EXPECT_FALSE(
        tracer.trace_piece(pieces[0], file_, {.progress = [](const PathProgress&) { return false; }}));
    EXPECT_FALSE(std::filesystem::exists(file_));
    EXPECT_TRUE(tracer.trace_piece(pieces[0], file_, {}));
    settings.seed = 2;
    PathTracer other(scene, size, settings, kAll);
    EXPECT_FALSE(other.has_piece(pieces[0], file_));
    EXPECT_THROW(other.add_up(pieces, {file_}), InputError);
    EXPECT_THROW(tracer.add_up(path_pieces(size, 11, 1), {file_}), InputError);
    std::filesystem::resize_file(file_, std::filesystem::file_size(file_) - 1);
    EXPECT_FALSE(tracer.has_piece(pieces[0], file_));
}

// What is measured in lux is diffuse, what is looked at is all that the scene says.
TEST_F(Progressive, APictureIsFullOfAllBouncesAndIrradianceAloneDiffuse) {
    const FrameScene scene = corner();
    const auto told = [&](const PathSettings& settings, const PathParts& parts, PathAov aov) {
        const PathTracer tracer(scene, ivec2(2), settings, parts);
        std::string text;
        for (const auto& [key, value] : tracer.description(aov)) {
            text += key == "transport" || key == "bounces" ? value + ' ' : "";
        }
        return text;
    };
    EXPECT_EQ(told({}, {.radiance = true}, PathAov::radiance), "full unlimited ");
    EXPECT_EQ(told({}, kAll, PathAov::indirect), "full unlimited ");
    EXPECT_EQ(told({}, {.indirect = true}, PathAov::indirect), "diffuse 2 ");
    PathSettings chosen;
    chosen.transport = Transport::diffuse;
    EXPECT_EQ(told(chosen, {.radiance = true}, PathAov::radiance), "diffuse 2 ");
    chosen.transport = Transport::full;
    EXPECT_EQ(told(chosen, {.radiance = true}, PathAov::radiance), "full 2 ") << "as many as are asked for";
}

TEST_F(Progressive, ResumedIsTheSameAsUninterrupted) {
    const FrameScene scene = corner();
    const ivec2 size(24, 16);
    PathSettings settings;
    settings.spp = 20;
    PathTracer whole(scene, size, settings, kAll);
    whole.render({});

    settings.spp = 7;
    PathTracer first(scene, size, settings, kAll);
    first.render({});
    first.save(file_);
    settings.spp = 20;
    PathTracer second(scene, size, settings, kAll);
    second.resume(file_);
    EXPECT_EQ(second.spp(), 7);
    second.render({});
    for (const PathAov aov : {PathAov::indirect, PathAov::direct, PathAov::radiance}) {
        EXPECT_EQ(second.image(aov), whole.image(aov));
        EXPECT_EQ(second.noise(aov), whole.noise(aov));
    }
}

TEST_F(Progressive, CancellingKeepsWhatIsDone) {
    const FrameScene scene = corner();
    PathSettings settings;
    settings.spp = 1000;
    PathTracer tracer(scene, ivec2(16), settings, kAll);
    PathControl control;
    control.progress = [](const PathProgress& p) { return p.spp < 1; };
    EXPECT_EQ(tracer.render(control).spp, 1);
    settings.spp = 1;
    EXPECT_EQ(tracer.image(PathAov::indirect), indirect(settings, ivec2(16)));
}

TEST_F(Progressive, RefusesCheckpointsThatDoNotFit) {
    const FrameScene scene = corner();
    PathSettings settings;
    settings.transport = Transport::diffuse;  // whose bounces matter
    settings.spp = 2;
    PathTracer tracer(scene, ivec2(8), settings, kAll);
    tracer.render({});
    tracer.save(file_);
    const std::vector<float> before = tracer.image(PathAov::radiance);

    const auto refuses = [&](PathTracer& other) {
        try {
            other.resume(file_);
        } catch (const InputError& error) {
            return std::string(error.what()).find(file_.string()) == 0;
        }
        return false;
    };
    FrameScene moved = scene;
    moved.lights[0].position.x += 0.01f;
    PathTracer other_light(moved, ivec2(8), settings, kAll);
    EXPECT_TRUE(refuses(other_light));
    PathTracer other_size(scene, ivec2(9, 8), settings, kAll);
    EXPECT_TRUE(refuses(other_size));
    PathTracer other_parts(scene, ivec2(8), settings, {.indirect = true});
    EXPECT_TRUE(refuses(other_parts));
    settings.bounces = 1;
    PathTracer other_bounces(scene, ivec2(8), settings, kAll);
    EXPECT_TRUE(refuses(other_bounces));

    const auto bytes = std::filesystem::file_size(file_);
    for (const std::uintmax_t size : {bytes - 1, std::uintmax_t{20}, std::uintmax_t{0}}) {
        std::filesystem::resize_file(file_, size);
        EXPECT_TRUE(refuses(tracer)) << size;
        EXPECT_EQ(tracer.image(PathAov::radiance), before) << "untouched";
    }
    EXPECT_THROW(tracer.save(folder_ / "none" / "sums"), InputError);
}

// relRMSE against a far better image, over what two halves of the worse one tell.
TEST_F(Progressive, TheNoiseIsWhatItClaims) {
    const FrameScene scene = corner();
    const ivec2 size(32);
    PathSettings settings;
    settings.spp = 4096;
    settings.seed = 99;
    PathTracer good(scene, size, settings, {.indirect = true});
    good.render({});
    const std::vector<float> truth = good.image(PathAov::indirect);
    for (const int spp : {15, 64}) {
        settings.spp = spp;
        settings.seed = 1;
        PathTracer tracer(scene, size, settings, {.indirect = true});
        tracer.render({});
        const std::vector<float> image = tracer.image(PathAov::indirect);
        double squares = 0, sum = 0, valid = 0;
        for (std::size_t i = 0; i < image.size(); ++i) {
            squares += std::pow(image[i] - truth[i], 2);
            sum += static_cast<double>(truth[i]);
            valid += truth[i] != 0 ? 1 : 0;
        }
        const double error = std::sqrt(squares / valid) / (sum / valid);
        EXPECT_NEAR(tracer.noise(PathAov::indirect) / error, 1, 0.15) << spp;
    }
}

TEST_F(Progressive, StopsAtTheTargetNoise) {
    const FrameScene scene = corner();
    PathSettings settings;
    settings.spp = 1 << 20;
    settings.target_noise = 0.1f;
    const auto samples = [&](int threads) {
        settings.threads = threads;
        PathTracer tracer(scene, ivec2(24), settings, {.indirect = true});
        const PathProgress end = tracer.render({});
        EXPECT_LE(tracer.noise(PathAov::indirect), 0.1);
        EXPECT_EQ(end.noise, tracer.noise(PathAov::indirect));
        EXPECT_EQ(end.share, 1);
        return tracer.spp();
    };
    const int spp = samples(1);
    EXPECT_GT(spp, 16);
    EXPECT_EQ(samples(2), spp) << "at the same sample, however long passes take";
}

TEST_F(Progressive, ATimeLimitGivesAtLeastOneSample) {
    const FrameScene scene = corner();
    PathSettings settings;
    settings.spp = 1 << 20;
    settings.time_limit = 1e-9f;
    PathTracer tracer(scene, ivec2(8), settings, {.indirect = true});
    EXPECT_GE(tracer.render({}).spp, 1);
}

// A light of 1e38 cd: what overflows is dropped and counted, and no pixel is lost to it.
TEST_F(Progressive, NotANumberIsNotSpread) {
    FrameScene scene = corner();
    scene.lights[0].light.intensity = 3e38f;
    PathSettings settings;
    settings.spp = 8;
    PathTracer tracer(scene, ivec2(16), settings, kAll);
    tracer.render({});
    EXPECT_GT(tracer.nan_count(), 0u);
    for (const PathAov aov : {PathAov::indirect, PathAov::direct, PathAov::radiance}) {
        for (const float v : tracer.image(aov)) {
            ASSERT_TRUE(std::isfinite(v));
        }
    }
}

TEST_F(Progressive, NothingToSeeIsBlack) {
    FrameScene scene = scene_of({}, {}, {}, vec3(0), vec3(0, 0, -1));
    PathSettings settings;
    settings.spp = 2;
    PathTracer tracer(scene, ivec2(4), settings, kAll);
    tracer.render({});
    EXPECT_EQ(tracer.image(PathAov::radiance), std::vector<float>(48));
    EXPECT_EQ(tracer.image(PathAov::depth), std::vector<float>(16));
    EXPECT_EQ(tracer.noise(PathAov::radiance), 0);
}

}  // namespace
}  // namespace lanthorn::reference::test
