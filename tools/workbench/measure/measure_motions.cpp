#include "lanthorn/workbench/measure_motions.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "engine/gpu/memory.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tools/workbench/measure/image_changes.h"
#include "tools/workbench/scene/median.h"

namespace lanthorn::workbench {

namespace {

constexpr float kNearBox = 0.4f;  // metres
constexpr double kSure = 3;       // standard errors: the few bright samples of references make two too few

// Whose own change the flicker is held against.
bool light_changes(Motion motion) {
    return motion == Motion::lamp || motion == Motion::dim || motion == Motion::figure;
}

bool has_change(Motion motion) {
    return light_changes(motion) || motion == Motion::walk || motion == Motion::pan;
}

// The frames whose references a motion wants: the last; where light changes steadily also that kChanges
// before; under a camera that moves the one before; of a figure all of these.
std::vector<int> reference_frames(Motion motion, int last) {
    switch (motion) {
        case Motion::lamp:
        case Motion::dim:
            return {last - kChanges, last};
        case Motion::walk:
        case Motion::pan:
            return {last - 1, last};
        case Motion::figure: {
            std::vector<int> all;
            for (int frame = last - kChanges; frame <= last; ++frame) {
                all.push_back(frame);
            }
            return all;
        }
        default:
            return {last};
    }
}

// A frame as far as changes want to know it.
struct Seen {
    ImageF indirect;
    Surfaces surfaces;
};

// Squares of changes between frames, sums over frames.
struct MotionChanges {
    double technique = 0;
    int count = 0;
    double reference = 0, reference_variance = 0;
    int reference_count = 0;
};

struct Costs {
    std::vector<double> gi, gi_cpu, direct, direct_cpu, ratio, ratio_cpu;
    std::map<std::string, std::vector<double>> pass, pass_cpu;

    void add(const FrameCost& cost) {
        gi.push_back(cost.gi);
        gi_cpu.push_back(cost.gi_cpu);
        direct.push_back(cost.direct());
        direct_cpu.push_back(cost.direct_cpu());
        ratio.push_back(cost.gi / cost.direct());
        ratio_cpu.push_back(cost.gi_cpu / cost.direct_cpu());
        for (const auto& [name, own] : cost.gi_passes) {
            pass[name].push_back(own.ms);
            pass_cpu[name].push_back(own.cpu);
        }
    }
    void store(MotionFigures& f) const {
        f.gi = median(gi);
        f.gi_cpu = median(gi_cpu);
        f.direct = median(direct);
        f.direct_cpu = median(direct_cpu);
        f.over_direct = median(ratio);
        f.over_direct_cpu = median(ratio_cpu);
        for (const auto& [name, times] : pass) {
            // What not every frame does counts as often as it is done.
            const double share = static_cast<double>(times.size()) / static_cast<double>(gi.size());
            f.gi_passes[name] = {share * median(times), share * median(pass_cpu.at(name))};
        }
    }
};

// One scene's measurement.
class Measurement {
  public:
    Measurement(const MotionScene& scene, const MotionJob& job, ReferencePairs& references)
        : scene_(scene), job_(job), references_(references) {}

    MotionFigures measure(Motion motion, const MotionCase& one);

  private:
    int bounces(const MotionCase& one) const {
        return job_.reference_bounces > 0 ? job_.reference_bounces : one.settings.get<int>("gi.bounces");
    }
    // The references of reference_frames().
    std::vector<const ReferencePair*> trace(Motion motion, int bounces);
    void follow(Seen&& now, int frame, const std::vector<const ReferencePair*>& truth, Motion motion);
    void follow_truth(const SamePoints& same, int frame, const std::vector<const ReferencePair*>& truth,
                      Motion motion);
    void finish_changes(MotionFigures& figures) const;

    const MotionScene& scene_;
    const MotionJob& job_;
    ReferencePairs& references_;
    std::optional<Seen> before_;
    MotionChanges changes_;
};

std::vector<const ReferencePair*> Measurement::trace(Motion motion, int bounces) {
    // Without OpenGL and at full detail: the same for all cases.
    MovingScene moving(scene_.data, scene_.view, motion, job_.frames);
    std::vector<const ReferencePair*> pairs;
    for (const int frame : reference_frames(motion, job_.frames)) {
        pairs.push_back(&references_.of(moving.show(frame), job_.size, bounces, scene_.name));
    }
    return pairs;
}

void Measurement::follow(Seen&& now, int frame, const std::vector<const ReferencePair*>& truth,
                         Motion motion) {
    if (before_) {
        const SamePoints same(before_->surfaces, now.surfaces);
        const auto moved = [&](const ImageF& image) { return same.seen_from_before(image); };
        const ImageF found = moved(now.indirect);
        changes_.technique +=
            mean_product(found, before_->indirect, found, before_->indirect, same.mask()).mean;
        follow_truth(same, frame, truth, motion);
        ++changes_.count;
    }
    before_ = std::move(now);
}

void Measurement::follow_truth(const SamePoints& same, int frame,
                               const std::vector<const ReferencePair*>& truth, Motion motion) {
    const bool steady = motion == Motion::lamp || motion == Motion::dim;
    const std::size_t back = motion == Motion::figure ? static_cast<std::size_t>(job_.frames - frame) : 0;
    if (frame != job_.frames && motion != Motion::figure) {
        return;  // there is no reference of this change alone
    }
    const ReferencePair& now = *truth[truth.size() - 1 - back];
    const ReferencePair& before = *truth[truth.size() - 2 - back];
    const auto moved = [&](const ImageF& image) { return same.seen_from_before(image); };
    const MeanProduct own = mean_product(moved(now.a), before.a, moved(now.b), before.b, same.mask());
    // Steady light changes by a share of the whole in each frame, and the whole stands out of noise.
    const double share = steady ? 1.0 / (kChanges * kChanges) : 1;
    changes_.reference += share * own.mean;
    changes_.reference_variance += share * share * own.variance;
    ++changes_.reference_count;
}

void Measurement::finish_changes(MotionFigures& figures) const {
    if (changes_.count == 0) {
        return;
    }
    const double mean = figures.error.reference_mean;
    const double change = std::sqrt(changes_.technique / changes_.count);
    figures.change = change / mean;
    const double noise = kSure * std::sqrt(changes_.reference_variance);
    figures.reference_change_below =
        std::sqrt((std::max(changes_.reference, 0.0) + noise) / changes_.reference_count) / mean;
    if (changes_.reference > noise) {
        const double own = std::sqrt(changes_.reference / changes_.reference_count);
        figures.reference_change = own / mean;
        figures.flicker = light_changes(figures.motion) ? change / own : kUnknown;
    }
}

MotionFigures Measurement::measure(Motion motion, const MotionCase& one) {
    before_.reset();
    changes_ = {};
    std::unique_ptr<gpu::Context> context;  // before what draws in it
    MovingScene moving(scene_.data, scene_.view, motion, job_.frames);
    MotionFigures figures;
    figures.motion = motion;
    figures.lacking = moving.lacking();
    if (!figures.lacking.empty()) {
        return figures;
    }
    figures.reach = moving.reach();
    const std::vector<const ReferencePair*> truth = trace(motion, bounces(one));

    context = gpu::create_headless_context();
    App& app = moving.shown().app();
    FrameMeter meter(app, comparable(one.settings), *context);
    app.view().size = job_.size;
    const auto read = [&](render::Aov aov) { return app.world().resource<Renderer>().frame->read(aov); };
    const auto surfaces = [&] {
        return surfaces_of(moving.shown().frame(), read(render::Aov::depth), read(render::Aov::normal));
    };
    Costs costs;
    double milliseconds = 0;
    std::optional<Truth> still;
    for (int i = 0; i <= job_.frames; ++i) {
        const FrameCost cost = meter.measure([&] { moving.show(i); });
        milliseconds += cost.frame;
        if (motion == Motion::cut ? i == job_.frames : i > job_.frames / 2) {
            costs.add(cost);
        }
        if (motion == Motion::rest) {
            if (!still) {
                still = truth_at(*truth.back(), surfaces(), surfaces().seen());
            }
            figures.by_frame.push_back(image_error(read(render::Aov::indirect), *still).relrmse);
        } else if (has_change(motion) && i >= job_.frames - kChanges) {
            follow({read(render::Aov::indirect), surfaces()}, i, truth, motion);
        }
    }
    costs.store(figures);
    const Surfaces last = surfaces();
    const bool box = motion == Motion::box || motion == Motion::box_rest;
    const ImageF indirect = read(render::Aov::indirect);
    const Truth all = truth_at(*truth.back(), last, last.seen());
    const Truth judged = box ? truth_at(*truth.back(), last, near_box(last, moving.box(), kNearBox)) : all;
    figures.error = image_error(indirect, judged);
    figures.noise = noise_of(judged);
    figures.unlit = unlit_pixels(read(render::Aov::direct), indirect, all);
    finish_changes(figures);
    if (motion == Motion::rest) {
        figures.seconds = 1e-3 * milliseconds;
        figures.worst_rise = 0;
        for (std::size_t i = 1; i < figures.by_frame.size(); ++i) {
            figures.worst_rise = std::max(figures.worst_rise, figures.by_frame[i] / figures.by_frame[i - 1]);
        }
    }
    figures.software = context->info().software;
    figures.gpu_mb = 1e-6 * static_cast<double>(gpu::allocated_bytes());
    figures.nan_count = app.world().resource<Renderer>().frame->nan_count() +
                        app.world().resource<gi::ActiveTechnique>().technique->statistics(false).nan_count;
    return figures;
}

}  // namespace

std::vector<std::vector<MotionFigures>> measure_motions(const MotionScene& scene,
                                                        const std::vector<MotionCase>& cases,
                                                        const MotionJob& job, ReferencePairs& references,
                                                        const std::function<void()>& done) {
    Measurement measurement(scene, job, references);
    std::vector<std::vector<MotionFigures>> result(cases.size());
    // Motion by motion, so that what disturbs the machine disturbs neighbours alike.
    for (const Motion motion : job.motions) {
        for (std::size_t c = 0; c < cases.size(); ++c) {
            MotionFigures figures = measurement.measure(motion, cases[c]);
            if (figures.lacking.empty() && motion == Motion::box) {
                figures.over_rest =
                    figures.error.local / measurement.measure(Motion::box_rest, cases[c]).error.local;
            }
            if (figures.lacking.empty() && motion == Motion::cut) {
                const auto lamp = std::ranges::find(result[c], Motion::lamp, &MotionFigures::motion);
                const double steady = lamp != result[c].end()
                                          ? lamp->error.relrmse
                                          : measurement.measure(Motion::lamp, cases[c]).error.relrmse;
                figures.over_rest = figures.error.relrmse / steady;
            }
            result[c].push_back(std::move(figures));
            done();
        }
    }
    references.forget();
    return result;
}

}  // namespace lanthorn::workbench
