// What a second view costs beside a second App: a level in which something always moves, shown by one view,
// by two views of one App, and by two Apps; by turns, so that what disturbs the machine disturbs all alike.
// Prints medians of processor time and GPU memory.
//   bench_views [LEVEL.glb [ROUNDS [TECHNIQUE]]]
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "engine/gpu/memory.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "tests/support/clocks.h"
#include "tests/support/median.h"
#include "tests/support/repository.h"

using namespace lanthorn;

namespace {

constexpr ivec2 kSize(320, 180);
constexpr int kWarmup = 8;  // frames

struct Level {
    App app;

    Level(const std::string& file, const Settings& settings) {
        add_scene_plugins(app);
        gi::add_picture_plugins(app, settings);
        spawn_scene(app, import_gltf(file), BadExtras::skip);
        app.view() = {.size = kSize, .camera = camera()};
    }
    ecs::Entity camera() {
        const auto cameras = app.world().query<ecs::With<CameraComponent>>().entities();
        return cameras.empty() ? ecs::kNullEntity : cameras.front();
    }
    // A light that wanders, so that shadows and photons are due.
    void frame(int number) {
        const auto lights = app.world().query<ecs::With<LightComponent>>().entities();
        if (!lights.empty()) {
            auto& local = app.world().get_mut<LocalTransform>(lights.front()).value;
            local.translation.x += number % 2 == 0 ? 0.01 : -0.01;
        }
        app.frame(1.0 / 60);
    }
};

// Apps that are shown together.
struct Stage {
    const char* name;
    std::vector<std::unique_ptr<Level>> levels;
    std::vector<double> ms;
    std::size_t bytes = 0;

    void show(int number) {
        const double start = support::processor_ms();
        for (const auto& level : levels) {
            level->frame(number);
        }
        glFinish();
        if (number >= kWarmup) {
            ms.push_back(support::processor_ms() - start);
        }
    }
};

int run(const std::string& file, int rounds, const std::string& technique) {
    const auto context = gpu::create_headless_context();
    SettingsSchema schema;
    gi::declare_settings(schema);
    Settings settings(schema);
    settings.set_from_text("gi.technique", technique);
    std::array<Stage, 3> stages{{{"one view", {}, {}}, {"two views", {}, {}}, {"two Apps", {}, {}}}};
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const std::size_t before = gpu::allocated_bytes();
        for (std::size_t apps = 0; apps < (i == 2 ? 2 : 1); ++apps) {
            stages[i].levels.push_back(std::make_unique<Level>(file, settings));
        }
        Level& level = *stages[i].levels.back();
        if (i == 1) {
            level.app.add_view(level.app.view());
        }
        for (int number = 0; number < kWarmup; ++number) {
            stages[i].show(number);
        }
        stages[i].bytes = gpu::allocated_bytes() - before;
    }
    for (int round = 0; round < rounds; ++round) {
        for (Stage& stage : stages) {
            stage.show(kWarmup + round);
        }
    }
    const double one = support::median(stages[0].ms);
    fmt::print("{} at {}x{} by {}, a light moves; {} frames each\n{:<10} {:>12} {:>8} {:>9}\n", file, kSize.x,
               kSize.y, technique, rounds, "", "processor ms", "of one", "GPU MiB");
    for (const Stage& stage : stages) {
        fmt::print("{:<10} {:>12.1f} {:>8.2f} {:>9.1f}\n", stage.name, support::median(stage.ms),
                   support::median(stage.ms) / one, static_cast<double>(stage.bytes) / (1 << 20));
    }
    fmt::print("a second view costs {:.2f} of a second App\n",
               (support::median(stages[1].ms) - one) / (support::median(stages[2].ms) - one));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc > 1 ? argv[1] : support::repository_file("assets/lantern-room.glb"),
                   argc > 2 ? std::atoi(argv[2]) : 3, argc > 3 ? argv[3] : "emc");
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return static_cast<int>(error.code());
    }
}
