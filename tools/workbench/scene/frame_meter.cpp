#include "lanthorn/workbench/frame_meter.h"

#include <epoxy/gl.h>

#include <ctime>

#include <chrono>
#include <utility>

#include "engine/gpu/memory.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/runtime/render_plugin.h"

namespace lanthorn::workbench {

namespace {

double wall_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

// A technique whose processor time is taken, all work of the GPU done where that is the processor too.
class MeteredTechnique final : public gi::Technique {
  public:
    MeteredTechnique(std::unique_ptr<gi::Technique> technique, bool software, std::shared_ptr<double> cpu,
                     std::shared_ptr<FrameMeter::Held> held)
        : technique_(std::move(technique)),
          software_(software),
          cpu_(std::move(cpu)),
          held_(std::move(held)) {}

    void plan(const FrameScene& scene, ivec2 size, const gi::GiSettings& settings) override {
        *cpu_ = 0;
        measured(held_->scene, [&] { technique_->plan(scene, size, settings); });
    }
    render::TracedLobes traced_lobes() const override { return technique_->traced_lobes(); }
    void update(const render::LightInputs& inputs) override {
        measured(held_->scene, [&] { technique_->update(inputs); });
    }
    render::IndirectLight indirect(const render::FrameInputs& inputs) override {
        render::IndirectLight light;
        measured(held_->picture, [&] { light = technique_->indirect(inputs); });
        return light;
    }
    void add_eyes(DetailHints& hints, const dvec3& origin) const override {
        technique_->add_eyes(hints, origin);
    }
    void add_irradiance(const render::LightInputs& inputs, const render::SensorTargets& targets) override {
        technique_->add_irradiance(inputs, targets);
    }
    std::uint64_t light_version() const override { return technique_->light_version(); }
    gi::ErrorEstimate estimate_error() override { return technique_->estimate_error(); }
    gi::GiStatistics statistics(bool count_photons) override { return technique_->statistics(count_photons); }

  private:
    template <class Step>
    void measured(std::int64_t& held, const Step& step) {
        const double start = processor_ms();
        const std::size_t before = gpu::allocated_bytes();
        step();
        held += static_cast<std::int64_t>(gpu::allocated_bytes()) - static_cast<std::int64_t>(before);
        if (software_) {
            glFinish();  // what the timer does at the end of the pass anyway
        }
        *cpu_ += processor_ms() - start;
    }

    std::unique_ptr<gi::Technique> technique_;
    bool software_;
    std::shared_ptr<double> cpu_;
    std::shared_ptr<FrameMeter::Held> held_;
};

// What each pass takes itself, into `cost`. Of two passes the inner one ends, and stands, first.
void add_own_costs(const std::vector<gpu::PassTimer::Span>& spans, FrameCost& cost) {
    struct Outer {
        const gpu::PassTimer::Span* span;
        std::map<std::string, FrameCost::Pass> passes;  // it, and those within
    };
    std::vector<Outer> outer;
    const auto add = [](std::map<std::string, FrameCost::Pass>& to, const Outer& from) {
        for (const auto& [name, pass] : from.passes) {
            to[name].ms += pass.ms;
            to[name].cpu += pass.cpu;
        }
    };
    for (const auto& span : spans) {
        Outer now{&span, {{span.name, {span.ms, span.cpu_ms}}}};
        for (; !outer.empty() && outer.back().span->start_ms >= span.start_ms; outer.pop_back()) {
            now.passes[span.name].ms -= outer.back().span->ms;
            now.passes[span.name].cpu -= outer.back().span->cpu_ms;
            add(now.passes, outer.back());
        }
        if (span.name == "gi") {
            add(cost.gi_passes, now);
        }
        outer.push_back(std::move(now));
    }
    for (const Outer& whole : outer) {
        add(cost.passes, whole);
    }
}

}  // namespace

double processor_ms() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

FrameMeter::FrameMeter(App& app, const Settings& settings, const gpu::Context& context)
    : app_(&app),
      software_(context.info().software),
      gi_cpu_(std::make_shared<double>(0)),
      held_(std::make_shared<Held>()) {
    gi::add_picture_plugins(app, settings, true);
    app.set_threads(1);
    const gi::TechniqueKind kind = gi::gi_settings(settings).technique;
    app.world().insert_resource(gi::ActiveTechnique{
        std::make_unique<MeteredTechnique>(gi::make_technique(kind), software_, gi_cpu_, held_), kind});
}

FrameCost FrameMeter::measure(const std::function<void()>& show) {
    const double wall_start = wall_ms(), cpu_start = processor_ms();
    show();
    glFinish();
    FrameCost cost;
    cost.frame = wall_ms() - wall_start;
    cost.frame_cpu = processor_ms() - cpu_start;
    cost.gi_cpu = *gi_cpu_;
    double passes = 0;
    const auto spans = app_->world().resource<Renderer>().timer->end_frame();
    add_own_costs(spans, cost);
    for (const auto& span : spans) {
        cost.gi += span.name == "gi" ? span.ms : 0;
        for (const char* pass : {"upload", "gbuffer", "light_maps", "gi", "direct", "composite"}) {
            passes += span.name == pass ? span.ms : 0;
        }
    }
    if (!software_) {
        cost.frame = passes;
    }
    return cost;
}

}  // namespace lanthorn::workbench
