// Pictures of half the width and height, up-scaled, beside those of full size: at rest, and as camera, box
// and figure move; and what that costs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
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
#include "tests/support/repository.h"

namespace lanthorn {
namespace {

using workbench::Motion;

constexpr ivec2 kWhole(320, 180);
constexpr int kFrames = 15;  // before the last: a picture at rest is given 16

// How a picture of kWhole is come by.
struct Way {
    const char* name;
    bool full;  // drawn in full
    const char* upscale;
};
constexpr Way kFull{"full", true, "none"};
constexpr Way kBlit{"blit", false, "none"};
constexpr Way kSpatial{"spatial", false, "spatial"};
constexpr Way kTemporal{"temporal", false, "temporal"};

const SettingsSchema& schema() {
    static const SettingsSchema* const declared = [] {
        auto* made = new SettingsSchema;
        gi::declare_settings(*made);
        return made;
    }();
    return *declared;
}

Settings settings_for(const Way& way) {
    Settings s(schema());
    s.apply_preset("low");
    s.set("render.exposure.darkest", 0.1f);
    s.set("render.antialias", true);
    s.set_from_text(std::string("render.upscale=") + way.upscale);
    if (const char* t = getenv("UPX")) { std::string all(t); std::size_t at; while (!all.empty()) { at = all.find(' '); s.set_from_text(all.substr(0, at)); all = at == std::string::npos ? "" : all.substr(at + 1); } }
    return s;
}

// As a window that scales a picture shows it.
ImageF presented(const render::FrameRenderer& renderer) {
    const gpu::Texture window = gpu::Texture::make_2d(GL_RGBA8, kWhole);
    const gpu::Framebuffer framebuffer({&window}, nullptr);
    renderer.present(framebuffer.id(), kWhole);
    const std::vector<float> upwards = window.read_floats(3);
    ImageF image{kWhole.x, kWhole.y, 3, {}, {}};
    const std::ptrdiff_t row = 3 * kWhole.x;
    for (std::ptrdiff_t y = kWhole.y - 1; y >= 0; --y) {
        image.pixels.insert(image.pixels.end(), upwards.begin() + y * row, upwards.begin() + (y + 1) * row);
    }
    return image;
}

struct Shown {
    std::vector<ImageF> pictures;  // of the last frames
    double upscale_ms = 0;         // processor time, median
};

// The last `kept` of kFrames + 1 frames.
Shown show(const SceneData& scene, const SceneChoice& choice, Motion motion, const Way& way,
           int kept) {
    const auto context = gpu::create_headless_context();
    workbench::MovingScene moving(scene, choice, motion, kFrames);
    EXPECT_EQ(moving.lacking(), "");
    App& app = moving.shown().app();
    gi::add_picture_plugins(app, settings_for(way), true);
    app.view().size = way.full ? kWhole : kWhole / 2;
    app.view().whole = kWhole;
    Shown shown;
    std::vector<double> times;
    for (int frame = 0; frame <= kFrames; ++frame) {
        moving.show(frame);
        const Renderer& renderer = app.world().resource<Renderer>();
        for (const auto& pass : renderer.timer->end_frame()) {
            if (pass.name == "upscale") {
                times.push_back(pass.cpu_ms);
            }
        }
        if (frame > kFrames - kept) {
            shown.pictures.push_back(presented(*renderer.frame));
        }
    }
    if (!times.empty()) {
        std::ranges::nth_element(times, times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
        shown.upscale_ms = times[times.size() / 2];
    }
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

struct Case {
    const char* name;
    const char* file;
    Motion motion;
    double most;  // FLIP
};

// For looking at.
void keep(const Shown& shown, const Case& c, const Way& way) {
    std::string name = c.name;
    std::ranges::replace(name, ' ', '-');
    std::erase(name, ',');
    std::filesystem::create_directories(LANTHORN_PICTURES);
    write_image(std::filesystem::path(LANTHORN_PICTURES) / ("upscaled-" + name + "-" + way.name + ".png"),
                shown.pictures.back());
    if (getenv("UPX4") && shown.pictures.size() == 4) { for (int i = 0; i < 4; ++i) write_image(std::filesystem::path(LANTHORN_PICTURES) / ("seq-" + name + "-" + way.name + std::to_string(i) + ".png"), shown.pictures[i]); }
}

class Upscaled : public testing::TestWithParam<Case> {};

TEST_P(Upscaled, IsNearerToFullSizeThanSingleFramesAre) {
    const Case& c = GetParam();
    const SceneData scene = import_gltf(support::repository_file(std::string("assets/") + c.file));
    const int kept = c.motion == Motion::rest ? 1 : 4;
    const Shown full = show(scene, {}, c.motion, kFull, kept);
    keep(full, c, kFull);
    const auto error_of = [&](const Way& way) {
        const Shown shown = show(scene, {}, c.motion, way, kept);
        keep(shown, c, way);
        return flip_of(shown, full);
    };
    const double blit = error_of(kBlit);
    const double spatial = error_of(kSpatial);
    const double temporal = error_of(kTemporal);
    std::printf("%-22s FLIP to full size: blit %.4f, spatial %.4f, temporal %.4f\n", c.name, blit, spatial,
                temporal);
    EXPECT_LE(temporal, c.most);
    EXPECT_LT(temporal, spatial);
    EXPECT_LT(temporal, blit);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Upscaled,
                         testing::Values(Case{"red-wall, rest", "levels/red-wall.glb", Motion::rest, 0.03},
                                         Case{"pool, rest", "levels/pool.glb", Motion::rest, 0.03},
                                         Case{"furnished, rest", "furnished.glb", Motion::rest, 0.03},
                                         Case{"two-rooms, walk", "two-rooms.glb", Motion::walk, 0.07},
                                         Case{"furnished, walk", "furnished.glb", Motion::walk, 0.07},
                                         Case{"two-rooms, box", "two-rooms.glb", Motion::box, 0.07},
                                         Case{"puppet, figure", "puppet.glb", Motion::figure, 0.07}),
                         [](const auto& tested) {
                             std::string name = tested.param.name;
                             std::erase_if(name, [](char c) { return c == ' ' || c == ',' || c == '-'; });
                             return name;
                         });

}  // namespace
}  // namespace lanthorn
