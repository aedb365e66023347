// One level, one moment, one picture: as `lanthorn render` shows it, as an App built by hand shows it, and
// whatever was shown on the way.
#include <gtest/gtest.h>

#include <algorithm>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/workbench/load_scene.h"
#include "lanthorn/workbench/render_job.h"
#include "tests/support/repository.h"

namespace lanthorn {
namespace {

constexpr ivec2 kSize(96, 72);
constexpr int kFrames = 6;

struct Picture {
    std::vector<float> final, indirect;
    bool operator==(const Picture&) const = default;
};

std::string file(const char* level) {
    return support::repository_file(std::string("assets/") + level);
}

const Settings& settings() {
    static const SettingsSchema* const schema = [] {
        auto* declared = new SettingsSchema;
        gi::declare_settings(*declared);
        return declared;
    }();
    static Settings low = [] {
        Settings s(*schema);
        s.apply_preset("low");
        return s;
    }();
    return low;
}

Picture by_the_command(const char* level) {
    workbench::RenderJob job;
    job.size = kSize;
    job.frames = kFrames;
    job.aovs = {render::Aov::final, render::Aov::indirect};
    const auto outcome =
        workbench::render_scene(workbench::load_scene(file(level), job.view), settings(), job, [](int) {});
    return {outcome.images[0].pixels, outcome.images[1].pixels};
}

Picture by_hand(const char* level, int threads) {
    const auto context = gpu::create_headless_context();
    App app;
    add_scene_plugins(app);
    gi::add_picture_plugins(app, settings());
    app.set_threads(threads);
    SceneData scene = import_gltf(file(level));
    const auto camera =
        std::ranges::find_if(scene.nodes, [](const NodeData& n) { return n.camera != kNone; });
    const auto number = static_cast<std::size_t>(camera - scene.nodes.begin());
    const std::vector<ecs::Entity> nodes = spawn_scene(app, std::move(scene), BadExtras::skip);
    app.view() = {kSize, nodes.at(number), {}};
    play_clip(app.world(), "", level);
    for (int i = 0; i < kFrames; ++i) {
        app.frame(1.0 / 60);
    }
    const render::FrameRenderer& renderer = *app.world().resource<Renderer>().frame;
    return {renderer.read(render::Aov::final).pixels, renderer.read(render::Aov::indirect).pixels};
}

class SamePicture : public testing::TestWithParam<const char*> {};

TEST_P(SamePicture, ByTheCommandAndByHand) {
    const Picture expected = by_the_command(GetParam());
    EXPECT_TRUE(by_hand(GetParam(), 0) == expected);
    EXPECT_TRUE(by_hand(GetParam(), 1) == expected) << "on one thread";
}

INSTANTIATE_TEST_SUITE_P(Levels, SamePicture, testing::Values("lantern-room.glb", "puppet.glb"));

}  // namespace
}  // namespace lanthorn
