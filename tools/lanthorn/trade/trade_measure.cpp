#include "tools/lanthorn/trade/trade_measure.h"

#include <ctime>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "lanthorn/core/colour.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/gpu/memory.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tools/image_metrics/flip.h"
#include "tools/image_metrics/metrics.h"
#include "tools/lanthorn/render/path_job.h"
#include "tools/lanthorn/scene/moved_lights.h"

namespace lanthorn::tools {

namespace {

using Clock = std::chrono::steady_clock;

// Of another sequence than the references', which a path point must not share.
constexpr int kPathPointSeed = 2;
constexpr double kLightStep = 0.002;  // a frame, of the scene's diagonal, as `measure flicker` has it

double wall_ms() {
    return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
}

// Of all threads of this process: llvmpipe's too.
double cpu_ms() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

// Times of each measured frame.
struct FrameTimes {
    std::vector<double> gi, gi_cpu, frame, direct, ratio, ratio_cpu;

    void add(double gi_ms, double gi_cpu_ms, double frame_ms, double frame_cpu_ms) {
        gi.push_back(gi_ms);
        gi_cpu.push_back(gi_cpu_ms);
        frame.push_back(frame_ms);
        direct.push_back(frame_ms - gi_ms);
        ratio.push_back(gi_ms / (frame_ms - gi_ms));
        ratio_cpu.push_back(gi_cpu_ms / (frame_cpu_ms - gi_cpu_ms));
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

// A technique whose processor time is taken, all work of the GPU done where that is the processor too.
class MeasuredTechnique final : public gi::Technique {
  public:
    MeasuredTechnique(std::unique_ptr<gi::Technique> technique, bool software, double& cpu)
        : technique_(std::move(technique)), software_(software), cpu_(cpu) {}

    void plan(const FrameScene& scene, ivec2 size, const gi::GiSettings& settings) override {
        cpu_ = 0;
        measured([&] { technique_->plan(scene, size, settings); });
    }
    void update(const render::LightInputs& inputs) override {
        measured([&] { technique_->update(inputs); });
    }
    render::IndirectLight indirect(const render::FrameInputs& inputs) override {
        render::IndirectLight light;
        measured([&] { light = technique_->indirect(inputs); });
        return light;
    }
    void add_eyes(DetailHints& hints, const dvec3& origin) const override {
        technique_->add_eyes(hints, origin);
    }
    gi::GiStatistics statistics(bool count_photons) override { return technique_->statistics(count_photons); }

  private:
    template <class Step>
    void measured(const Step& step) {
        const double start = cpu_ms();
        step();
        if (software_) {
            glFinish();  // what the timer does at the end of the pass anyway
        }
        cpu_ += cpu_ms() - start;
    }

    std::unique_ptr<gi::Technique> technique_;
    bool software_;
    double& cpu_;  // of this frame, milliseconds
};

// Punctual lights that move nothing else.
MovedLights find_lights(ecs::World& world) {
    std::vector<ecs::Entity> parents;
    world.query<ecs::Read<Parent>>().each([&](const Parent& parent) { parents.push_back(parent.entity); });
    MovedLights lights(world);
    const auto punctual = world.query<ecs::With<LightComponent>, ecs::Without<MeshInstances>>().entities();
    for (const ecs::Entity light : punctual) {
        if (std::ranges::find(parents, light) == parents.end()) {
            lights.add(light, false);
        }
    }
    return lights;
}

TradeView view_raster(const TradePoint& point, const TradeMeasurement& job, const Settings& settings) {
    std::unique_ptr<gpu::Context> context;  // before what draws in it
    ShownScene shown(load_scene(point.scene, job.view), job.view);
    App& app = shown.app();
    ecs::World& world = app.world();
    shown.show_at(job.view.time.value_or(0));
    shown.hold();
    const double diagonal = shown.frame().diagonal();
    MovedLights lights = find_lights(world);

    context = gpu::create_headless_context();
    const bool software = context->info().software;
    gi::add_picture_plugins(app, settings, true);
    app.view().size = job.size;
    app.set_threads(1);  // so that processor time is the technique's alone
    const gi::GiSettings gi_settings = gi::gi_settings(settings);
    double gi_cpu = 0;
    world.insert_resource(gi::ActiveTechnique{
        std::make_unique<MeasuredTechnique>(gi::make_technique(gi_settings.technique), software, gi_cpu),
        gi_settings.technique});

    FrameTimes times;
    const int count = job.warmup + job.frames;
    for (int i = 0; i < count; ++i) {
        lights.move(kLightStep * diagonal * (count - 1 - i), 0);
        // Another march and another filter, by the last bit, in every second frame: photons and paths are
        // traced anew without punctual lights too.
        auto& marched = world.resource_mut<gi::GiSettings>();
        const auto other = [&](float value) {
            return (count - 1 - i) % 2 == 0 ? value : std::nextafter(value, 1e30f);
        };
        marched.emc_threshold = other(gi_settings.emc_threshold);
        marched.coarse.sigma = other(gi_settings.coarse.sigma);
        const double wall_start = wall_ms(), cpu_start = cpu_ms();
        app.show();
        glFinish();
        const double wall = wall_ms() - wall_start, cpu = cpu_ms() - cpu_start;
        double gi = 0, passes = 0;
        for (const auto& span : world.resource<Renderer>().timer->end_frame()) {
            gi += span.name == "gi" ? span.ms : 0;
            for (const char* pass : {"upload", "gbuffer", "light_maps", "gi", "direct", "composite"}) {
                passes += span.name == pass ? span.ms : 0;
            }
        }
        if (i >= job.warmup) {
            times.add(gi, gi_cpu, software ? wall : passes, cpu);
        }
    }
    const render::FrameRenderer& renderer = *world.resource<Renderer>().frame;
    TradeView view;
    times.store(view.figures);
    view.figures.cost_ms = software ? view.figures.gi_cpu.median : view.figures.gi.median;
    view.indirect = renderer.read(render::Aov::indirect);
    view.final = renderer.read(render::Aov::final);
    const gi::GiStatistics statistics = world.resource<gi::ActiveTechnique>().technique->statistics(true);
    view.figures.photons_stored = static_cast<double>(statistics.photons.stored);
    view.figures.photons_lost = static_cast<double>(statistics.photons.lost);
    view.figures.nan_count = static_cast<double>(renderer.nan_count() + statistics.nan_count);
    view.figures.gpu_mb = static_cast<double>(gpu::allocated_bytes()) * 1e-6;
    view.figures.renderer = context->info().renderer;
    return view;
}

TradeView view_path(const TradePoint& point, const TradeMeasurement& job, Settings settings) {
    settings.set<int>("gi.seed", kPathPointSeed);
    const SceneData scene = load_scene(point.scene, job.view);
    const auto ignore = [](double) {};
    RenderJob render;
    render.size = job.size;
    render.view = job.view;
    render.view.time = job.view.time.value_or(0);
    render.aovs = {render::Aov::indirect};
    const double cpu_start = cpu_ms();
    RenderOutcome timed = path_trace_scene(scene, settings, render, "", ignore);
    const double cpu = cpu_ms() - cpu_start;
    render.aovs = {render::Aov::final};
    RenderOutcome shown = path_trace_scene(scene, settings, render, "", ignore);

    TradeView view;
    const double wall = timed.frames.front().ms;
    view.figures.gi = view.figures.frame = spread_of({wall});
    view.figures.gi_cpu = spread_of({cpu});
    view.figures.cost_ms = cpu;
    view.figures.nan_count = static_cast<double>(timed.nan_count);
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

TradeView view_point(const TradePoint& point, const TradeMeasurement& job, const SettingsSchema& schema) {
    const Settings settings = point.settings(schema);
    return point.technique == "path" ? view_path(point, job, settings) : view_raster(point, job, settings);
}

void compare_with_references(TradeView& view, const TradeReferences& references) {
    TradeFigures& f = view.figures;
    const ImageF same = read_image(references.same), all = read_image(references.all);
    const auto by_same = image_metrics::compare(view.indirect, same, "the point", references.same);
    const auto by_all = image_metrics::compare(view.indirect, all, "the point", references.all);
    f.relrmse = without_noise(by_same.all.relrmse, same);
    f.flux = by_same.all.flux;
    f.relrmse_all = without_noise(by_all.all.relrmse, all);
    f.flux_all = by_all.all.flux;
    f.reference_noise = std::stod(same.metadata.contains("noise") ? same.metadata.at("noise") : "0");

    ImageF final_reference = read_image(references.final);
    for (float& v : final_reference.pixels) {
        v = srgb_from_linear(v);
    }
    const auto map = image_metrics::flip(view.final, final_reference);
    double sum = 0;
    for (const float v : map) {
        sum += v;
    }
    f.flip = sum / static_cast<double>(map.size());
}

ImageF picture_of(const TradeView& view, const std::string& reference, int width) {
    const ImageF truth = read_image(reference);
    const double mean =
        image_metrics::compare(view.indirect, truth, "the point", reference).all.reference_mean;
    const ImageF error = image_metrics::heat_map(image_metrics::relative_error(view.indirect, truth, mean),
                                                 truth.width, truth.height);
    const ImageF left = scaled(view.final, width), right = scaled(error, width);
    ImageF both{left.width + right.width, left.height, 3, {}, {}};
    const auto row = static_cast<std::ptrdiff_t>(3 * left.width);
    for (int y = 0; y < left.height; ++y) {
        for (const ImageF* half : {&left, &right}) {
            const auto start = half->pixels.begin() + y * row;
            both.pixels.insert(both.pixels.end(), start, start + row);
        }
    }
    return both;
}

}  // namespace lanthorn::tools
