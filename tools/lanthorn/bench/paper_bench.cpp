#include "tools/lanthorn/bench/paper_bench.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/workbench/frame_meter.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/scene_generator/scenes.h"
#include "tools/workbench/scene/light_sources.h"
#include "tools/workbench/scene/median.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

constexpr double kFrameSeconds = 1.0 / 30;
constexpr double kSlide = 0.02;   // metres a frame: 0.6 m/s
constexpr int kSlideFrames = 16;  // to and fro

// The row's mover, which slides along x.
class Slider {
  public:
    Slider(ecs::World& world, const char* name) : world_(&world) {
        if (name == nullptr) {
            return;
        }
        for (const ecs::Entity entity :
             world.query<ecs::With<Name>, ecs::With<LocalTransform>>().entities()) {
            if (world.get<Name>(entity).value == name) {
                entity_ = entity;
                start_ = world.get<LocalTransform>(entity).value;
                return;
            }
        }
        throw std::logic_error(std::string("bench: no node ") + name);
    }

    void place(int frame) {
        if (entity_ == ecs::Entity()) {
            return;
        }
        const int turn = frame % kSlideFrames;
        Transform moved = start_;
        moved.translation.x += kSlide * std::min(turn, kSlideFrames - turn);
        world_->get_mut<LocalTransform>(entity_).value = moved;
    }

  private:
    ecs::World* world_;
    ecs::Entity entity_;
    Transform start_;
};

}  // namespace

SceneData paper_scene(const PaperRow& row) {
    for (const auto* list : {&scene_generator::all_scenes(), &scene_generator::large_scenes()}) {
        for (const scene_generator::NamedScene& scene : *list) {
            if (scene.name == row.scene) {
                SceneData made = scene.make();
                made.source = row.scene;
                return made;
            }
        }
    }
    throw std::logic_error(std::string("bench: no scene ") + row.scene);
}

int paper_share(int photons, double share) {
    return photons == 0 ? 0 : std::max(1, static_cast<int>(std::lround(photons * share)));
}

void apply_row(const PaperRow& row, double share, Settings& settings) {
    // The setting has no 0.
    settings.set<int>("gi.photons", std::max(1, paper_share(row.photons, share)));
    settings.set<int>("gi.caustics.photons", paper_share(row.caustic_photons, share));
    settings.set<int>("gi.bounces", row.bounces);
    settings.set<int>("gi.emc.count", row.maps);
}

PaperFigures measure_row(const SceneData& scene, const Settings& settings, const PaperJob& job) {
    std::unique_ptr<gpu::Context> context;  // before what draws in it
    ShownScene shown(scene, {});
    shown.show_at(0);
    if (!job.moving) {
        shown.hold();
    }
    ecs::World& world = shown.world();
    Slider mover(world, job.mover);
    DimmedLights lamps(world);
    for (const auto& sources : {punctual_lights(world), emissive_meshes(world)}) {
        std::ranges::for_each(sources, [&](ecs::Entity source) { lamps.add(source); });
    }

    context = gpu::create_headless_context();
    FrameMeter meter(shown.app(), settings, *context);
    shown.app().view().size = job.size;
    std::vector<double> frame, gi, frame_cpu, gi_cpu;
    std::map<std::string, std::vector<double>> passes;
    for (int i = 0; i < job.warmup + job.frames; ++i) {
        lamps.dim(i % 2 == 0 ? 1.0f : std::nextafter(1.0f, 2.0f));
        if (job.moving) {
            mover.place(i);
        }
        const FrameCost cost = meter.measure([&] {
            if (job.moving) {
                shown.show_at((i + 1) * kFrameSeconds);
            } else {
                shown.app().show();
            }
        });
        stop_if_asked("bench", "what was measured until then is printed");
        if (i < job.warmup) {
            continue;
        }
        frame.push_back(cost.frame);
        gi.push_back(cost.gi);
        frame_cpu.push_back(cost.frame_cpu);
        gi_cpu.push_back(cost.gi_cpu);
        for (const auto& [name, pass] : cost.gi_passes) {
            passes[name].push_back(pass.ms);
        }
    }
    PaperFigures figures;
    figures.frame = median(frame);
    figures.gi = median(gi);
    figures.frame_cpu = median(frame_cpu);
    figures.gi_cpu = median(gi_cpu);
    for (const auto& [name, times] : passes) {
        // What not every frame does counts as often as it is done.
        figures.passes[name] = median(times) * static_cast<double>(times.size()) / job.frames;
    }
    const gi::GiStatistics statistics = world.resource<gi::ActiveTechnique>().technique->statistics(true);
    figures.photons = statistics.of<gi::PhotonStatistics>().emitted;
    figures.nan_count = world.resource<Renderer>().frame->nan_count() + statistics.nan_count;
    figures.renderer = context->info().renderer;
    return figures;
}

}  // namespace lanthorn::tools
