#include "tools/workbench/measure/frame_costs.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/workbench/frame_meter.h"
#include "tools/workbench/scene/median.h"

namespace lanthorn::workbench {

namespace {

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

// Of the measured frames.
class Collected {
  public:
    explicit Collected(bool software) : software_(software) {}

    void add(double wall_ms, const FrameCost& cost, const gi::GiPlan& plan) {
        const double whole = software_ ? cost.frame_cpu : wall_ms;
        double passes = 0;
        for (const auto& [name, pass] : cost.passes) {
            Times& times = passes_[name];
            times.ms.push_back(software_ ? pass.cpu : pass.ms);
            times.clock.push_back(pass.ms);
            times.gi = times.gi || cost.gi_passes.contains(name);
            passes += times.ms.back();
        }
        whole_.push_back(whole);
        clock_.push_back(wall_ms);
        outside_.push_back(whole - passes);
        follow(plan);
    }
    void store(FrameCosts& costs) const {
        const auto frames = static_cast<double>(whole_.size());
        for (const auto& [name, times] : passes_) {
            const double share = static_cast<double>(times.ms.size()) / frames;
            costs.passes[name] = {share * median(times.ms), sum(times.ms) / frames,
                                  share * median(times.clock), times.gi};
        }
        costs.frames = static_cast<int>(whole_.size());
        costs.whole = median(whole_);
        costs.whole_mean = sum(whole_) / frames;
        costs.whole_clock = median(clock_);
        costs.outside = median(outside_);
        costs.plan = lines_;
    }

  private:
    void follow(const gi::GiPlan& plan) {
        for (const gi::PlanEntry& entry : plan.entries) {
            auto line = std::ranges::find(lines_, entry.pass, &PlanLine::pass);
            if (line == lines_.end()) {
                line = lines_.insert(lines_.end(), {entry.pass, 0, "", entry.why});
            }
            const int frames_before = static_cast<int>(whole_.size()) - 1;
            const bool always_done = line->ran == frames_before;
            if (entry.on) {
                ++line->ran;
                line->size = entry.size;
            }
            if (!entry.on || always_done) {
                line->why = entry.why;
            }
        }
    }

    struct Times {
        std::vector<double> ms, clock;
        bool gi = false;
    };
    bool software_;
    std::map<std::string, Times> passes_;
    std::vector<double> whole_, clock_, outside_;
    std::vector<PlanLine> lines_;
};

}  // namespace

double FrameCosts::passes_ms() const {
    return std::accumulate(passes.begin(), passes.end(), 0.0,
                           [](double s, const auto& pass) { return s + pass.second.ms; });
}

double FrameCosts::passes_mean() const {
    return std::accumulate(passes.begin(), passes.end(), 0.0,
                           [](double s, const auto& pass) { return s + pass.second.mean; });
}

FrameCosts measure_frame_costs(const MotionScene& scene, Motion motion, const Settings& settings,
                               const FrameCostsJob& job) {
    FrameCosts costs;
    costs.motion = motion;
    const int last = job.warmup + job.frames - 1;
    std::unique_ptr<gpu::Context> context;  // before what draws in it
    MovingScene moving(scene.data, scene.view, motion, last);
    costs.lacking = moving.lacking();
    if (!costs.lacking.empty()) {
        return costs;
    }
    context = gpu::create_headless_context();
    costs.software = context->info().software;
    costs.renderer = context->info().renderer;
    App& app = moving.shown().app();
    FrameMeter meter(app, settings, *context);
    app.view().size = job.size;
    const auto technique = [&]() -> gi::Technique& {
        return *app.world().resource_mut<gi::ActiveTechnique>().technique;
    };
    Collected collected(costs.software);
    for (int i = 0; i <= last; ++i) {
        const auto begun = std::chrono::steady_clock::now();
        const FrameCost cost = meter.measure([&] { moving.show(i); });
        const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - begun;
        if (i >= job.warmup) {
            collected.add(wall.count(), cost, technique().statistics(false).plan);
        }
    }
    collected.store(costs);
    const Renderer& renderer = app.world().resource<Renderer>();
    const gi::GiStatistics statistics = technique().statistics(true);
    costs.memory = scene_memory(moving.shown().frame(), *renderer.frame, statistics, meter.held());
    costs.nan_count = renderer.frame->nan_count() + statistics.nan_count;
    return costs;
}

}  // namespace lanthorn::workbench
