// Pictures of half the width and height, up-scaled, beside those of full size: at rest, and as camera, box
// and figure move; and what that costs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/workbench/flip.h"
#include "lanthorn/workbench/motions.h"
#include "tests/support/clocks.h"
#include "tests/support/median.h"
#include "tests/support/repository.h"

namespace lanthorn {
namespace {

using workbench::Motion;

constexpr int kFrames = 15;  // before the last: a picture at rest is given 16

// How a picture is come by.
struct Way {
    const char* name;
    bool full;  // drawn in full
    const char* upscale;
    float sharpness = 0.5f;  // the best of 0, 0.5 and 1 for each
    int seed = 1;
};
constexpr Way kFull{"full", true, "none"};
constexpr Way kOtherRays{"other-rays", true, "none", 0.5f, 2};
constexpr Way kBlit{"blit", false, "none"};
constexpr Way kSpatial{"spatial", false, "spatial", 1};
constexpr Way kTemporal{"temporal", false, "temporal"};

struct Case {
    const char* name;
    const char* file;
    Motion motion;
    const char* technique;
    ivec2 whole;
    double most;  // FLIP; 0: that of pictures of full size whose light took other rays
};

const SettingsSchema& schema() {
    static const SettingsSchema* const declared = [] {
        auto* made = new SettingsSchema;
        gi::declare_settings(*made);
        return made;
    }();
    return *declared;
}

Settings settings_for(const Case& c, const Way& way) {
    Settings s(schema());
    s.apply_preset("low");
    s.set_from_text(std::string("gi.technique=") + c.technique);
    s.set("gi.seed", way.seed);
    s.set("render.upscale.sharpness", way.sharpness);
    if (!way.full) {  // as lamplighter has it
        s.set("gi.gather.points", s.get<int>("gi.gather.points") / 4);
    }
    s.set("render.exposure.darkest", 0.1f);
    s.set("render.antialias", true);
    s.set_from_text(std::string("render.upscale=") + way.upscale);
    return s;
}

// As a window that scales a picture shows it.
ImageF presented(const render::FrameRenderer& renderer, ivec2 size) {
    const gpu::Texture window = gpu::Texture::make_2d(GL_RGBA8, size);
    const gpu::Framebuffer framebuffer({&window}, nullptr);
    renderer.present(framebuffer.id(), size);
    const std::vector<float> upwards = window.read_floats(3);
    ImageF image{size.x, size.y, 3, {}, {}};
    const std::ptrdiff_t row = 3 * std::ptrdiff_t{size.x};
    for (std::ptrdiff_t y = size.y - 1; y >= 0; --y) {
        image.pixels.insert(image.pixels.end(), upwards.begin() + y * row, upwards.begin() + (y + 1) * row);
    }
    return image;
}

struct Shown {
    std::vector<ImageF> pictures;         // of the last frames
    double frame_ms = 0, upscale_ms = 0;  // processor time, medians of the last eight
};

// The last `kept` of kFrames + 1 frames.
Shown show(const SceneData& scene, const Case& c, const Way& way, int kept) {
    const auto context = gpu::create_headless_context();
    workbench::MovingScene moving(scene, {}, c.motion, kFrames);
    EXPECT_EQ(moving.lacking(), "");
    App& app = moving.shown().app();
    gi::add_picture_plugins(app, settings_for(c, way), true);
    app.view().size = way.full ? c.whole : c.whole / 2;
    app.view().whole = c.whole;
    Shown shown;
    std::vector<double> frames, upscales;
    for (int frame = 0; frame <= kFrames; ++frame) {
        const double start = support::processor_ms();
        moving.show(frame);
        const Renderer& renderer = app.world().resource<Renderer>();
        const auto passes = renderer.timer->end_frame();
        if (frame > kFrames - 8) {
            frames.push_back(support::processor_ms() - start);
        }
        for (const auto& pass : passes) {
            if (pass.name == "upscale" && frame > kFrames - 8) {
                upscales.push_back(pass.cpu_ms);
            }
        }
        if (frame > kFrames - kept) {
            shown.pictures.push_back(presented(*renderer.frame, c.whole));
        }
    }
    shown.frame_ms = support::median(frames);
    shown.upscale_ms = support::median(upscales);
    return shown;
}

double flip_of(const Shown& found, const Shown& full) {
    double sum = 0;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < full.pictures.size(); ++i) {
        for (const float each : workbench::flip(found.pictures[i], full.pictures[i])) {
            sum += static_cast<double>(each);
            ++pixels;
        }
    }
    return sum / static_cast<double>(pixels);
}

// For looking at.
void keep(const Shown& shown, const Case& c, const Way& way) {
    std::string name = c.name;
    std::ranges::replace(name, ' ', '-');
    std::erase(name, ',');
    std::filesystem::create_directories(LANTHORN_PICTURES);
    write_image(std::filesystem::path(LANTHORN_PICTURES) / ("upscaled-" + name + "-" + way.name + ".png"),
                shown.pictures.back());
}

class Upscaled : public testing::TestWithParam<Case> {};

TEST_P(Upscaled, IsNearerToFullSizeThanSingleFramesAre) {
    const Case& c = GetParam();
    const SceneData scene = import_gltf(support::repository_file(std::string("assets/") + c.file));
    const int kept = c.motion == Motion::rest ? 1 : 4;
    const Shown full = show(scene, c, kFull, kept);
    keep(full, c, kFull);
    std::printf("%s, %s, %dx%d: FLIP to full size, processor time of a frame and of it up-scaling\n", c.name,
                c.technique, c.whole.x, c.whole.y);
    const auto error_of = [&](const Way& way) {
        const Shown shown = show(scene, c, way, kept);
        keep(shown, c, way);
        const double error = flip_of(shown, full);
        std::printf("    %-10s %.4f %6.0f ms %5.1f ms\n", way.name, error, shown.frame_ms, shown.upscale_ms);
        return error;
    };
    std::printf("    %-10s %.4f %6.0f ms\n", kFull.name, 0.0, full.frame_ms);
    const double temporal = error_of(kTemporal);
    EXPECT_LT(temporal, error_of(kBlit));
    EXPECT_LT(temporal, error_of(kSpatial));
    EXPECT_LE(temporal, c.most > 0 ? c.most : error_of(kOtherRays));
}

// The level as it was when bounds were set: an up-scaler is not measured by what levels become.
constexpr const char* kRedWall = "../tests/gpu/runtime/red-wall.glb";
constexpr ivec2 kLarge(640, 360), kSmall(320, 180);
INSTANTIATE_TEST_SUITE_P(
    Scenes, Upscaled,
    testing::Values(Case{"red-wall, rest", kRedWall, Motion::rest, "none", kLarge, 0.03},
                    Case{"pool, rest", "levels/pool.glb", Motion::rest, "none", kLarge, 0.03},
                    Case{"red-wall, lit, rest", kRedWall, Motion::rest, "emc", kSmall, 0},
                    Case{"two-rooms, walk", "two-rooms.glb", Motion::walk, "none", kLarge, 0.07},
                    Case{"red-wall, pan", kRedWall, Motion::pan, "none", kLarge, 0.07},
                    Case{"furnished, walk", "furnished.glb", Motion::walk, "emc", kSmall, 0.07},
                    Case{"two-rooms, box", "two-rooms.glb", Motion::box, "emc", kSmall, 0.07},
                    Case{"puppet, figure", "puppet.glb", Motion::figure, "emc", kSmall, 0.07}),
    [](const auto& tested) {
        std::string name = tested.param.name;
        std::erase_if(name, [](char c) { return c == ' ' || c == ',' || c == '-'; });
        return name;
    });

}  // namespace
}  // namespace lanthorn
