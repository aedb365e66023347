#include "lanthorn/workbench/trade_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "engine/gpu/memory.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/workbench/flip.h"
#include "lanthorn/workbench/frame_meter.h"
#include "lanthorn/workbench/load_scene.h"
#include "lanthorn/workbench/metrics.h"
#include "lanthorn/workbench/motions.h"
#include "lanthorn/workbench/path_job.h"
#include "tools/workbench/scene/light_sources.h"
#include "tools/workbench/scene/moved_nodes.h"

namespace lanthorn::workbench {

namespace {

// Of another sequence than the references', which a path point must not share.
constexpr int kAfterPathSeed = 1;
constexpr double kLightStep = 0.002;  // a frame, of the scene's diagonal, as `measure flicker` has it

// Times of each measured frame.
struct FrameTimes {
    std::vector<double> gi, gi_cpu, frame, direct, ratio, ratio_cpu;

    void add(const FrameCost& cost) {
        gi.push_back(cost.gi);
        gi_cpu.push_back(cost.gi_cpu);
        frame.push_back(cost.frame);
        direct.push_back(cost.direct());
        ratio.push_back(cost.gi / cost.direct());
        ratio_cpu.push_back(cost.gi_cpu / cost.direct_cpu());
    }
    void store(TradeFigures& f) const {
        f.gi = spread_of(gi);
        f.gi_cpu = spread_of(gi_cpu);
        f.frame = spread_of(frame);
        f.direct = spread_of(direct);
        f.ratio = spread_of(ratio);
        f.ratio_cpu = spread_of(ratio_cpu);
    }
};

// Punctual lights that move nothing else.
MovedNodes find_lights(ecs::World& world) {
    std::vector<ecs::Entity> parents;
    world.query<ecs::Read<Parent>>().each([&](const Parent& parent) { parents.push_back(parent.entity); });
    MovedNodes lights(world);
    const auto punctual = world.query<ecs::With<LightComponent>, ecs::Without<MeshInstances>>().entities();
    for (const ecs::Entity light : punctual) {
        if (std::ranges::find(parents, light) == parents.end()) {
            lights.add(light, false);
        }
    }
    return lights;
}

// Shows one after the other so many frames of a scene that stands, in which light changes.
class ChangingLight {
  public:
    ChangingLight(ShownScene& shown, int frames)
        : shown_(shown),
          lights_(find_lights(shown.world())),
          dimmed_(shown.world()),
          step_(kLightStep * static_cast<double>(shown.frame().diagonal())),
          left_(frames) {
        if (lights_.empty()) {
            for (const auto& sources : {punctual_lights(shown.world()), emissive_meshes(shown.world())}) {
                std::ranges::for_each(sources, [&](ecs::Entity source) { dimmed_.add(source); });
            }
        }
    }

    void show() {
        --left_;
        lights_.move(dvec3(step_ * left_, 0, 0), 0);
        // By the last bit, in every second frame: other light is new work for each technique, and leaves what
        // it remembers of geometry alone.
        dimmed_.dim(left_ % 2 == 0 ? 1.0f : std::nextafter(1.0f, 2.0f));
        shown_.app().show();
    }

  private:
    ShownScene& shown_;
    MovedNodes lights_;
    DimmedLights dimmed_;
    double step_;  // metres
    int left_;
};

// VmHWM: the most that was in memory of this program alone. What getrusage() says may be that of the process
// which started it.
double most_resident_mb() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmHWM:")) {
            return 1.024e-3 * std::stod(line.substr(6));
        }
    }
    return 0;
}

MovingScene moving_scene(const ListedScene& listed, TradeMotion motion, const TradeMeasurement& job) {
    return {load_scene(listed.file, listed.view), listed.view,
            motion == TradeMotion::light ? Motion::rest : motion_named(name_of(motion)),
            job.warmup + job.frames - 1};
}

// Why `moving` has no such motion, and what would; empty: it has.
std::string lacking_for(const MovingScene& moving, TradeMotion motion) {
    return moving.lacking().empty()
               ? std::string()
               : fmt::format("{}, expected some for --motion {}", moving.lacking(), name_of(motion));
}

TradeView view_raster(const TradePoint& point, const TradeMeasurement& job, const Settings& settings) {
    std::unique_ptr<gpu::Context> context;  // before what draws in it
    const ListedScene listed = listed_scene(point.scene, job.view);
    const int count = job.warmup + job.frames;
    const bool light_alone = point.motion == TradeMotion::light;
    MovingScene moving = moving_scene(listed, point.motion, job);
    if (const std::string lacking = lacking_for(moving, point.motion); !lacking.empty()) {
        throw InputError(listed.file, "", lacking);
    }
    App& app = moving.shown().app();
    ecs::World& world = app.world();
    ChangingLight light(moving.shown(), count);

    context = gpu::create_headless_context();
    FrameMeter meter(app, settings, *context);
    app.view().size = job.size;

    FrameTimes times;
    for (int i = 0; i < count; ++i) {
        const FrameCost cost = meter.measure([&] { light_alone ? light.show() : void(moving.show(i)); });
        if (i >= job.warmup) {
            times.add(cost);
        }
    }
    const render::FrameRenderer& renderer = *world.resource<Renderer>().frame;
    TradeView view;
    times.store(view.figures);
    view.figures.cost_ms = context->info().software ? view.figures.gi_cpu.median : view.figures.gi.median;
    view.indirect = renderer.read(render::Aov::indirect);
    view.final = renderer.read(render::Aov::final);
    const gi::GiStatistics statistics = world.resource<gi::ActiveTechnique>().technique->statistics(true);
    view.figures.photons_stored = static_cast<double>(statistics.of<gi::PhotonStatistics>().stored);
    view.figures.photons_lost = static_cast<double>(statistics.of<gi::PhotonStatistics>().lost);
    view.figures.nan_count = static_cast<double>(renderer.nan_count() + statistics.nan_count);
    view.figures.gpu_mb = static_cast<double>(gpu::allocated_bytes()) * 1e-6;
    view.figures.rss_mb = most_resident_mb();
    view.figures.renderer = context->info().renderer;
    return view;
}

TradeView view_path(const TradePoint& point, const TradeMeasurement& job, Settings settings) {
    settings.set<int>("gi.seed", settings.get<int>("gi.seed") + kAfterPathSeed);
    const ListedScene listed = listed_scene(point.scene, job.view);
    const auto ignore = [](double) {};
    RenderJob render;
    render.size = job.size;
    render.view = last_view(listed, point.motion, job).view;
    const SceneData scene = load_scene(listed.file, render.view);
    render.aovs = {render::Aov::indirect};
    const double cpu_start = processor_ms();
    RenderOutcome timed = path_trace_scene(scene, settings, render, "", ignore);
    const double cpu = processor_ms() - cpu_start;
    render.aovs = {render::Aov::final};
    RenderOutcome shown = path_trace_scene(scene, settings, render, "", ignore);

    TradeView view;
    const double wall = timed.frames.front().ms;
    view.figures.gi = view.figures.frame = spread_of({wall});
    view.figures.gi_cpu = spread_of({cpu});
    view.figures.cost_ms = cpu;
    view.figures.nan_count = static_cast<double>(timed.nan_count);
    view.figures.rss_mb = most_resident_mb();
    view.figures.renderer = "Embree";
    view.indirect = std::move(timed.images.front());
    view.final = std::move(shown.images.front());
    return view;
}

// relRMSE against the truth that `reference` is a noisy image of.
double without_noise(double relrmse, const ImageF& reference) {
    const auto noise = reference.metadata.find("noise");
    const double n = noise == reference.metadata.end() ? 0 : std::stod(noise->second);
    return std::sqrt(std::max(0.0, relrmse * relrmse - n * n));
}

// Averages of the pixels that fall into each of `width` columns, and as many rows as keep the shape.
ImageF scaled(const ImageF& image, int width) {
    ImageF small;
    small.width = std::min(width, image.width);
    small.height = std::max(1, image.height * small.width / image.width);
    small.channels = 3;
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            const int x0 = x * image.width / small.width, x1 = (x + 1) * image.width / small.width;
            const int y0 = y * image.height / small.height, y1 = (y + 1) * image.height / small.height;
            for (int c = 0; c < 3; ++c) {
                float sum = 0;
                for (int v = y0; v < y1; ++v) {
                    for (int u = x0; u < x1; ++u) {
                        sum += image.at(u, v, c);
                    }
                }
                small.pixels.push_back(sum / static_cast<float>((x1 - x0) * (y1 - y0)));
            }
        }
    }
    return small;
}

}  // namespace

LastView last_view(const ListedScene& scene, TradeMotion motion, const TradeMeasurement& job) {
    LastView last{scene.view, {}};
    last.view.time = scene.view.time.value_or(0);
    if (motion == TradeMotion::light) {
        return last;
    }
    const MovingScene moving = moving_scene(scene, motion, job);
    last.lacking = lacking_for(moving, motion);
    last.view.box = moving.placed_box();
    if (motion == TradeMotion::figure) {
        *last.view.time += kFigureStep * (job.warmup + job.frames - 1);
    }
    return last;
}

TradeView view_point(const TradePoint& point, const TradeMeasurement& job, const SettingsSchema& schema) {
    const Settings settings = point.settings(schema);
    return gi::technique_entry(gi::gi_settings(settings).technique).is_reference
               ? view_path(point, job, settings)
               : view_raster(point, job, settings);
}

void compare_with_references(TradeView& view, const TradeReferences& references) {
    TradeFigures& f = view.figures;
    const ImageF same = read_image(references.same), all = read_image(references.all);
    const auto by_same = workbench::compare(view.indirect, same, "the point", references.same);
    const auto by_all = workbench::compare(view.indirect, all, "the point", references.all);
    f.relrmse = without_noise(by_same.all.relrmse, same);
    f.flux = by_same.all.flux;
    f.relrmse_all = without_noise(by_all.all.relrmse, all);
    f.flux_all = by_all.all.flux;
    f.reference_noise = std::stod(same.metadata.contains("noise") ? same.metadata.at("noise") : "0");

    ImageF final_reference = read_image(references.final);
    for (float& v : final_reference.pixels) {
        v = srgb_from_linear(v);
    }
    const auto map = workbench::flip(view.final, final_reference);
    double sum = 0;
    for (const float v : map) {
        sum += v;
    }
    f.flip = sum / static_cast<double>(map.size());
}

ImageF picture_of(const TradeView& view, const std::string& reference, int width) {
    const ImageF truth = read_image(reference);
    const double mean = workbench::compare(view.indirect, truth, "the point", reference).all.reference_mean;
    const ImageF error =
        workbench::heat_map(workbench::relative_error(view.indirect, truth, mean), truth.width, truth.height);
    const ImageF left = scaled(view.final, width), right = scaled(error, width);
    ImageF both{left.width + right.width, left.height, 3, {}, {}};
    const std::ptrdiff_t row = std::ptrdiff_t{3} * left.width;
    for (int y = 0; y < left.height; ++y) {
        for (const ImageF* half : {&left, &right}) {
            const auto start = half->pixels.begin() + y * row;
            both.pixels.insert(both.pixels.end(), start, start + row);
        }
    }
    return both;
}

}  // namespace lanthorn::workbench
