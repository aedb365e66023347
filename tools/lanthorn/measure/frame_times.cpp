#include "tools/lanthorn/measure/frame_times.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <memory>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/workbench/trade_point.h"
#include "tools/workbench/scene/median.h"

namespace lanthorn::tools {

namespace {

using Clock = std::chrono::steady_clock;

// Waits for a frame when more than kInFlight are on their way.
class FramesInFlight {
  public:
    FramesInFlight() = default;
    ~FramesInFlight() { std::ranges::for_each(fences_, glDeleteSync); }
    FramesInFlight(const FramesInFlight&) = delete;
    FramesInFlight& operator=(const FramesInFlight&) = delete;

    void drawn() {
        fences_.push_back(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
        if (fences_.size() >= kInFlight) {
            glClientWaitSync(fences_.front(), GL_SYNC_FLUSH_COMMANDS_BIT, GL_TIMEOUT_IGNORED);
            glDeleteSync(fences_.front());
            fences_.pop_front();
        }
    }

  private:
    std::deque<GLsync> fences_;
};

void measure_clock(MovingScene& moving, const FramesJob& job, FrameTimes& times) {
    std::vector<double> apart;
    FramesInFlight frames;
    double processor = 0;
    Clock::time_point before;
    for (int i = 0; i <= job.warmup + job.frames; ++i) {
        moving.show(i);
        frames.drawn();
        const Clock::time_point now = Clock::now();
        if (i > job.warmup) {
            apart.push_back(std::chrono::duration<double, std::milli>(now - before).count());
        } else {
            processor = processor_ms();
        }
        before = now;
    }
    times.processor = (processor_ms() - processor) / job.frames;
    const Spread spread = spread_of(apart);
    times.median = spread.median;
    times.p95 = spread.p95;
}

void measure_passes(MovingScene& moving, FrameMeter& meter, const FramesJob& job, FrameTimes& times) {
    std::map<std::string, std::vector<double>> passes;
    std::vector<double> whole;
    for (int i = 0; i <= job.warmup + job.frames; ++i) {
        const FrameCost cost = meter.measure([&] { moving.show(i); });
        if (i > job.warmup) {
            double sum = 0;
            for (const auto& [name, pass] : cost.passes) {
                passes[name].push_back(pass.ms);
                sum += pass.ms;
            }
            whole.push_back(sum);
        }
    }
    times.gpu = median(whole);
    for (const auto& [name, of] : passes) {
        // What not every frame does counts as often as it is done.
        times.passes[name] = median(of) * static_cast<double>(of.size()) / job.frames;
    }
}

}  // namespace

FrameTimes measure_frames(const SceneData& scene, const SceneChoice& choice, Motion motion,
                          const Settings& settings, const FramesJob& job) {
    FrameTimes times;
    times.motion = motion;
    for (const bool timed : {false, true}) {
        std::unique_ptr<gpu::Context> context;  // before what draws in it
        MovingScene moving(scene, choice, motion, job.warmup + job.frames);
        times.lacking = moving.lacking();
        if (!times.lacking.empty()) {
            return times;
        }
        context = gpu::create_headless_context();
        App& app = moving.shown().app();
        app.view().size = job.size;
        if (timed) {
            FrameMeter meter(app, settings, *context);
            measure_passes(moving, meter, job, times);
        } else {
            gi::add_picture_plugins(app, settings);
            measure_clock(moving, job, times);
            times.nan_count =
                app.world().resource<Renderer>().frame->nan_count() +
                app.world().resource<gi::ActiveTechnique>().technique->statistics(false).nan_count;
            times.renderer = context->info().renderer;
        }
    }
    return times;
}

}  // namespace lanthorn::tools
