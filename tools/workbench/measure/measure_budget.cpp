#include "tools/workbench/measure/measure_budget.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <memory>
#include <numeric>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/workbench/frame_meter.h"
#include "tools/workbench/render/budget_run.h"

namespace lanthorn::workbench {

namespace {

// Another program that takes a core as long as this lives.
class OtherProgram {
  public:
    OtherProgram() : child_(fork()) {
        while (child_ == 0) {
            if (getppid() == 1) {
                _exit(0);  // nobody is left to end it
            }
        }
    }
    ~OtherProgram() {
        if (child_ > 0) {
            kill(child_, SIGKILL);
            waitpid(child_, nullptr, 0);
        }
    }
    OtherProgram(const OtherProgram&) = delete;
    OtherProgram& operator=(const OtherProgram&) = delete;

  private:
    pid_t child_;
};

double wall_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace

double BudgetRecord::percentile(double share, std::size_t from) const {
    std::vector<double> values;
    for (std::size_t i = from; i < frames.size(); ++i) {
        values.push_back(frames[i].ms);
    }
    if (values.empty()) {
        return 0;
    }
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

double BudgetRecord::mean(std::size_t from) const {
    double sum = 0;
    for (std::size_t i = from; i < frames.size(); ++i) {
        sum += frames[i].ms;
    }
    return from < frames.size() ? sum / static_cast<double>(frames.size() - from) : 0;
}

BudgetRecord measure_budget(const MotionScene& scene, const Settings& settings, const BudgetRunJob& job,
                            const std::function<void()>& done) {
    const auto at = [&](double share) { return static_cast<int>(share * job.frames); };
    const int first = at(kMotionFrom), last = at(kMotionUntil);
    std::unique_ptr<gpu::Context> context;  // before what draws in it
    MovingScene moving(scene.data, scene.view, job.motion, last - first);
    if (!moving.lacking().empty()) {
        throw InputError(scene.name, "", moving.lacking());
    }
    context = gpu::create_headless_context();
    App& app = moving.shown().app();
    gi::add_picture_plugins(app, settings, true);
    app.view().size = job.size;
    BudgetRun run(app, settings, job.size, job.wish, true);
    std::unique_ptr<OtherProgram> other;
    BudgetRecord record;
    for (int i = 0; i < job.frames; ++i) {
        const bool core = i >= at(kCoreFrom) && i < at(kCoreUntil);
        if (core != (other != nullptr)) {
            other = core ? std::make_unique<OtherProgram>() : nullptr;
        }
        const double wall = wall_ms(), cpu = processor_ms();
        run.begin_frame();
        moving.show(std::clamp(i - first, 0, last - first));
        run.estimate();
        const auto passes = app.world().resource<Renderer>().timer->end_frame();
        const double ms = wall_ms() - wall, cpu_ms = processor_ms() - cpu;
        run.end_frame(ms, cpu_ms, passes);
        record.frames.push_back({.ms = job.wish.processor ? cpu_ms : ms,
                                 .error = run.error(),
                                 .scale = run.control().ladder().rungs[run.rung()].scale,
                                 .rung = run.rung(),
                                 .moves = i > first && i <= last,
                                 .core = core});
        done();
    }
    record.outcome = run.outcome();
    return record;
}

}  // namespace lanthorn::workbench
