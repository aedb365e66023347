// `lanthorn render --turntable`: an animated picture of a model from all sides.
#include <gtest/gtest.h>
#include <webp/demux.h>

#include <cmath>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/scene/view.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/render_job.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/refused.h"
#include "tests/unit/tools/run_program.h"
#include "tools/scene_generator/glb_bytes.h"
#include "tools/scene_generator/scenes.h"
#include "tools/workbench/render/turntable.h"

namespace lanthorn {
namespace turntable_test {

using testing_tools::Outcome;
using Words = std::vector<std::string>;

struct Decoded {
    int width = 0, height = 0, loops = -1;
    std::vector<std::vector<std::uint8_t>> frames;  // RGBA
    std::vector<int> ends;                          // milliseconds
};

Decoded decode(const std::string& file) {
    const std::string bytes = testing_tools::file_bytes(file);
    const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
    Decoded decoded;
    WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, nullptr);
    if (decoder == nullptr) {
        ADD_FAILURE() << file << " is no animated WebP";
        return decoded;
    }
    WebPAnimInfo info;
    WebPAnimDecoderGetInfo(decoder, &info);
    decoded.width = static_cast<int>(info.canvas_width);
    decoded.height = static_cast<int>(info.canvas_height);
    decoded.loops = static_cast<int>(info.loop_count);
    while (WebPAnimDecoderHasMoreFrames(decoder) != 0) {
        std::uint8_t* rgba = nullptr;
        int end = 0;
        if (WebPAnimDecoderGetNext(decoder, &rgba, &end) == 0) {
            ADD_FAILURE() << file << ": a frame cannot be decoded";
            break;
        }
        decoded.frames.emplace_back(rgba, rgba + std::size_t{4} * info.canvas_width * info.canvas_height);
        decoded.ends.push_back(end);
    }
    WebPAnimDecoderDelete(decoder);
    return decoded;
}

// Mean absolute difference of 8-bit values.
double difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += std::abs(static_cast<double>(a[i]) - b[i]);
    }
    return sum / static_cast<double>(a.size());
}

class Turntable : public testing::Test {
  protected:
    void SetUp() override {
        std::ofstream(path("model.glb"), std::ios::binary) << scene_generator::glb_bytes(model());
    }
    // Things without walls around, light or camera: a table and chairs.
    static SceneData model() {
        SceneData scene = scene_generator::clutter();
        for (NodeData& node : scene.nodes) {
            node.light = kNone;
            node.camera = kNone;
        }
        for (Material& material : scene.materials) {
            material.emissive = vec3(0);
        }
        return scene;
    }
    std::string path(const std::string& name) const { return folder_.path(name); }
    static Outcome run(Words words) {
        words.insert(words.begin(), "render");
        return testing_tools::run_program(LANTHORN_BINARY, words);
    }
    testing_tools::TemporaryFolder folder_;
};

TEST_F(Turntable, GoesOnceRoundAModelAndBeginsWhereRenderLooks) {
    const Words common{path("model.glb"), "--size", "96x64", "--preset", "low"};
    Words turn = common, still = common;
    turn.insert(turn.end(), {"--turntable", path("turn.webp"), "--frames", "12"});
    still.insert(still.end(), {"-o", path("still.png")});
    const Outcome result = run(turn);
    ASSERT_EQ(result.code, 0) << result.err;
    ASSERT_EQ(run(still).code, 0);

    const Decoded decoded = decode(path("turn.webp"));
    EXPECT_EQ(decoded.width, 96);
    EXPECT_EQ(decoded.height, 64);
    EXPECT_EQ(decoded.loops, 0) << "for ever";
    ASSERT_EQ(decoded.frames.size(), 12u);
    EXPECT_EQ(decoded.ends.back(), 12 * 333);
    const ImageF picture = read_image(path("still.png"));
    std::vector<std::uint8_t> first;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                first.push_back(static_cast<std::uint8_t>(std::lround(255 * picture.at(x, y, c))));
            }
            first.push_back(255);
        }
    }
    const double coding = difference(decoded.frames.front(), first);
    const double opposite = difference(decoded.frames.front(), decoded.frames[6]);
    const double back = difference(decoded.frames.front(), decoded.frames.back());
    EXPECT_LT(coding, 3) << "of 255, by the lossy coding";
    EXPECT_GT(opposite, 4 * coding) << "the other side is seen";
    EXPECT_LT(back, opposite) << "a twelfth of the turn is left";
}

TEST_F(Turntable, TheFirstPictureIsRendersBitByBit) {
    SettingsSchema schema;
    workbench::declare_all_settings(schema);
    Settings settings(schema);
    settings.apply_preset("low");
    const std::string file = support::repository_file("assets/clutter.glb");
    workbench::TurntableJob job;
    job.size = ivec2(48, 32);
    job.pictures = 4;
    job.warmup = 2;
    std::vector<ImageF> pictures;
    workbench::render_turntable(workbench::load_scene(file, job.view), settings, job,
                                [&](const ImageF& picture) { pictures.push_back(picture); });
    workbench::RenderJob still;
    still.size = job.size;
    still.warmup = job.warmup;
    const workbench::RenderOutcome outcome =
        workbench::render_scene(workbench::load_scene(file, still.view), settings, still, [](int) {});
    ASSERT_EQ(pictures.size(), 4u);
    EXPECT_EQ(pictures.front().pixels, outcome.images.front().pixels);
    for (std::size_t i = 1; i < pictures.size(); ++i) {
        EXPECT_NE(pictures[i].pixels, pictures[i - 1].pixels) << i;
    }
}

TEST_F(Turntable, AModelWithoutCameraKeepsItsMiddleAndItsDistance) {
    workbench::SceneView view;
    ShownScene shown(workbench::load_scene(path("model.glb"), view), view);
    shown.show_at(0);
    const vec3 middle = workbench::framed_box(shown.frame()).centre();
    EXPECT_EQ(middle, shown.frame().bounds.centre());
    const CameraView start = shown.frame().camera;
    for (const double radians : {0.0, 0.5, 3.0, 6.0}) {
        const CameraView look = workbench::turned(start, middle, radians);
        const vec3 before(start.view * vec4(middle, 1)), now(look.view * vec4(middle, 1));
        EXPECT_LT(glm::length(now - before), 1e-5f * shown.frame().diagonal())
            << "in the same place of the picture";
        EXPECT_NEAR(look.position.y, start.position.y, 1e-5f * shown.frame().diagonal());
        EXPECT_LT(glm::length(vec3(look.view * vec4(look.position, 1))), 1e-5f * shown.frame().diagonal());
    }
    // Seen from above, counter-clockwise: from the front (+Z) to the right (+X).
    EXPECT_GT(workbench::turned(start, middle, 0.5).position.x, start.position.x);
}

// A long box fits from the front, and its ends would leave the picture when it is seen along them.
TEST_F(Turntable, StepsBackWhereAnythingWouldLeaveThePicture) {
    Aabb box;
    box.add(vec3(-2, 0, -0.5f));
    box.add(vec3(2, 1.5f, 0.5f));
    CameraView start;
    start.camera.y_fov = glm::radians(45.0f);
    start.position = vec3(0, 1, 3.76f);
    start.view = glm::lookAt(start.position, box.centre(), vec3(0, 1, 0));
    const auto all_in = [&](const CameraView& view, float aspect) {
        const mat4 clip = projection_matrix(view.camera, aspect, 10) * view.view;
        bool in = true;
        for (int i = 0; i < 24 * 8; ++i) {
            const vec3 at(i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                          i & 4 ? box.upper.z : box.lower.z);
            const mat4 turn = glm::translate(mat4(1), box.centre()) *
                              glm::rotate(mat4(1), static_cast<float>(i / 8) * 0.2617994f, vec3(0, 1, 0)) *
                              glm::translate(mat4(1), -box.centre());
            const vec4 q = clip * turn * vec4(at, 1);
            in = in && q.w > 0 && std::abs(q.x) <= 1.0001f * q.w && std::abs(q.y) <= 1.0001f * q.w;
        }
        return in;
    };
    const CameraView back = workbench::stepped_back(start, box, 24, 1.5f, 10);
    EXPECT_FALSE(all_in(start, 1.5f)) << "nothing to do";
    EXPECT_TRUE(all_in(back, 1.5f));
    EXPECT_LT(glm::distance(back.position, box.centre()), 1.7f * glm::distance(start.position, box.centre()));
    EXPECT_LT(glm::distance(vec3(back.view * vec4(back.position, 1)), vec3(0)), 1e-5f);
    // Where it is seen in part from the start, the camera stays.
    EXPECT_EQ(workbench::stepped_back(start, box, 24, 0.3f, 10), start);
    EXPECT_EQ(workbench::stepped_back(back, box, 24, 1.5f, 10), back);
}

TEST_F(Turntable, WhatStandsOnAWideFloorIsInTheMiddle) {
    FrameScene scene;
    Instance floor, thing;
    floor.bounds.add(vec3(-10, -0.01f, -10));
    floor.bounds.add(vec3(10, 0, 10));
    thing.bounds.add(vec3(2, 0, 1));
    thing.bounds.add(vec3(3, 1, 2));
    scene.instances = {floor, thing};
    scene.bounds.add(floor.bounds);
    scene.bounds.add(thing.bounds);
    EXPECT_EQ(workbench::framed_box(scene).centre(), vec3(2.5f, 0.5f, 1.5f));
    scene.instances.pop_back();
    EXPECT_EQ(workbench::framed_box(scene).centre(), scene.bounds.centre());
}

TEST_F(Turntable, BadInputIsOneLineAndLeavesNothing) {
    const std::string out = path("turn.webp");
    const auto refused = [&](Words words, const std::string& part) {
        words.insert(words.begin(), {path("model.glb"), "--size", "32x32", "--preset", "low"});
        testing_tools::expect_refusal(run(words), part, words);
        EXPECT_EQ(folder_.files(), Words{"model.glb"});
    };
    refused({"--turntable", path("turn.gif")}, "expected .webp");
    refused({"--turntable", out, "--frames", "1"}, "--frames: found 1, expected from 2 to 1000");
    refused({"--turntable", out, "--frames", "1001"}, "--frames: found 1001");
    refused({"--turntable", out, "-o", path("a.png")}, "found -o beside it");
    refused({"--turntable", out, "--aov", "direct"}, "found --aov beside it");
    refused({"--turntable", out, "--stats", path("s.json")}, "found --stats beside it");
    refused({"--turntable", out, "--technique", "path"}, "found --technique path beside it");
    refused({"--turntable", out, "--budget-ms", "10"}, "found a budget beside it");
    refused({"--turntable", out, "--camera", "roof"}, "roof");
    refused({"--turntable", path("none/turn.webp")}, "there is no folder");
    testing_tools::expect_refusal(run({path("model.glb"), "--size", "16384x16", "--turntable", out}),
                                  "expected at most 16383 pixels");
    testing_tools::expect_refusal(run({path("lost.glb"), "--turntable", out}), "lost.glb");
    testing_tools::expect_refusal(run({path("model.glb")}), "--turntable FILE.webp");
}

TEST_F(Turntable, AFullDiskLeavesTheOldFile) {
    std::ofstream(path("turn.webp")) << "old";
    const Outcome result = [&] {
        const support::FileSizeLimit limit(300);
        return run({support::repository_file("assets/cornell.glb"), "--size", "48x48", "--technique", "none",
                    "--frames", "2", "--turntable", path("turn.webp")});
    }();
    testing_tools::expect_refusal(result, "turn.webp: cannot be written: File too large");
    EXPECT_EQ(testing_tools::file_bytes(path("turn.webp")), "old");
}

TEST_F(Turntable, ASignalLeavesNothing) {
    const Outcome result = testing_tools::run_program(
        "/usr/bin/timeout",
        {"--preserve-status", "--signal", "INT", "4", LANTHORN_BINARY, "render", path("model.glb"), "--size",
         "64x64", "--warmup", "100000", "--turntable", path("turn.webp")});
    EXPECT_EQ(result.code, 130) << result.err;
    EXPECT_EQ(folder_.files(), Words{"model.glb"});
}

}  // namespace turntable_test
}  // namespace lanthorn
