// The frame: cornell, 512x512, 20 k photons, 2 bounces, k = 8, static geometry, a light that moves.
// Prints milliseconds by pass, the ratio of indirect to direct light in the same frames, and what a still
// frame costs.
//   bench_gi [FRAMES]
// The box's own lamp is a panel, which cannot move without moving geometry; it is darkened here, and a spot
// of the same flux hangs in its place and swings.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "engine/gpu/memory.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "tests/support/median.h"
#include "tests/support/repository.h"

using namespace lanthorn;

namespace {

constexpr ivec2 kSize(512);

// Milliseconds of each frame by pass; passes of one name are added up.
class Figures {
  public:
    void add(const std::vector<gpu::PassTimer::Span>& spans) {
        std::map<std::string, double> sums;
        for (const auto& span : spans) {
            sums[span.name] += span.ms;
        }
        double direct = 0;
        for (const char* pass : {"upload", "gbuffer", "light_maps", "direct", "composite"}) {
            direct += sums[pass];
        }
        ratios_.push_back(sums["gi"] / direct);
        sums["= direct part"] = direct;
        for (const auto& [name, ms] : sums) {
            passes_[name].push_back(ms);
        }
    }
    void print(const char* title) const {
        fmt::print("{}\n", title);
        for (const auto& [name, values] : passes_) {
            fmt::print("  {:<22}{:9.3f} ms\n", name, support::median(values));
        }
        fmt::print("  {:<22}{:9.3f}\n", "gi / direct part", support::median(ratios_));
    }

  private:
    std::map<std::string, std::vector<double>> passes_;
    std::vector<double> ratios_;
};

int run(int frames) {
    SceneData data = import_gltf(support::repository_file("assets/cornell.glb"));
    vec3 lamp(0);
    for (Mesh& mesh : data.meshes) {
        if (data.materials[mesh.material].emits()) {
            lamp = mesh.bounds.centre();
        }
    }
    for (Material& material : data.materials) {
        material.emissive = vec3(0);
    }
    const auto context = gpu::create_headless_context();
    App app;
    add_scene_plugins(app);
    app.add<RenderPlugin>(true).add<gi::GiPlugin>();
    ecs::World& world = app.world();
    for (const ecs::Entity e : spawn(world, std::move(data))) {
        if (world.has<CameraComponent>(e)) {
            app.view().camera = e;
        }
    }
    Light spot;
    spot.type = LightType::spot;
    spot.intensity = 40;
    spot.outer_cone = 1.04f;
    LocalTransform hangs;
    hangs.value.rotation = glm::angleAxis(-kPi / 2, vec3(1, 0, 0));
    const ecs::Entity light = world.create(hangs, LightComponent{spot});
    app.view().size = kSize;
    world.resource_mut<gi::GiSettings>().edit<gi::EmcSettings>().final_stage = gi::EmcFinal::splat;
    const gi::GiSettings settings = world.resource<gi::GiSettings>();

    const auto frame = [&](double swing) {
        world.get_mut<LocalTransform>(light).value.translation = dvec3(lamp) + dvec3(swing, -0.02, 0);
        app.show();
        glFinish();
        return world.resource<Renderer>().timer->end_frame();
    };

    frame(0);
    frame(0.01);
    Figures moving;
    for (int i = 0; i < frames; ++i) {
        moving.add(frame(0.1 * std::sin(0.5 * (i + 1))));
    }
    frame(0);
    Figures still;
    for (int i = 0; i < frames; ++i) {
        still.add(frame(0));
    }
    fmt::print("{}, OpenGL {}; cornell {}x{}, {} photons, {} bounces, k = {}; medians of {} frames\n",
               context->info().renderer, context->info().version, kSize.x, kSize.y, settings.photons,
               settings.bounces, settings.of<gi::EmcSettings>().count, frames);
    moving.print("moving light, static geometry:");
    still.print("still scene:");
    const gi::GiStatistics statistics = world.resource<gi::ActiveTechnique>().technique->statistics(true);
    fmt::print(
        "maps in use {}, {:.1f} MB of maps, {:.1f} MB of GPU memory in all; photons stored {}, lost {}\n",
        statistics.of<gi::EmcStatistics>().k,
        static_cast<double>(statistics.of<gi::EmcStatistics>().map_bytes) / 1e6,
        static_cast<double>(gpu::allocated_bytes()) / 1e6, statistics.of<gi::PhotonStatistics>().stored,
        statistics.of<gi::PhotonStatistics>().lost);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc > 1 ? std::max(1, std::atoi(argv[1])) : 20);
    } catch (const Error& error) {
        fmt::print(stderr, "bench_gi: {}\n", error.what());
        return static_cast<int>(error.code());
    }
}
