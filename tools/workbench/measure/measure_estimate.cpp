#include "tools/workbench/measure/measure_estimate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tools/workbench/measure/image_changes.h"

namespace lanthorn::workbench {

namespace {

constexpr double kSure = 2;  // standard errors: what is nearer to none is lost in the references' noise

bool is_certain(const ImageError& error) {
    return error.relrmse > kSure * error.relrmse_sigma && error.local > kSure * error.local_sigma;
}

class Estimates {
  public:
    Estimates(const MotionScene& scene, const MotionJob& job, ReferencePairs& references)
        : scene_(scene), job_(job), references_(references) {}

    std::vector<EstimatePoint> measure(Motion motion, const MotionCase& one) {
        std::unique_ptr<gpu::Context> context;  // before what draws in it
        MovingScene moving(scene_.data, scene_.view, motion, job_.frames);
        points_.clear();
        if (!moving.lacking().empty()) {
            return points_;
        }
        const ReferencePair& truth = trace(motion, one);
        context = gpu::create_headless_context();
        App& app = moving.shown().app();
        FrameMeter meter(app, comparable(one.settings), *context);
        app.view().size = job_.size;
        for (int i = 0; i <= job_.frames; ++i) {
            const FrameCost cost = meter.measure([&] { moving.show(i); });
            if (i == 0) {
                gi::technique_of(app, ViewId::first).estimate_error();  // whose programs it compiles
            }
            if (i == job_.frames || (motion == Motion::rest && i == 0)) {
                const bool first = i == 0;
                judge(app, moving.shown().frame(), truth,
                      {.scene = scene_.name,
                       .of = one.name,
                       .motion = first ? "first" : name_of(motion),
                       .held = false,
                       .estimate = {},
                       .truth = {},
                       .estimate_ms = 0,
                       .gi_ms = cost.gi_cpu});
            }
        }
        return points_;
    }

  private:
    // Without OpenGL and at full detail: the same for all cases.
    const ReferencePair& trace(Motion motion, const MotionCase& one) {
        MovingScene moving(scene_.data, scene_.view, motion, job_.frames);
        const int bounces =
            job_.reference_bounces > 0 ? job_.reference_bounces : one.settings.get<int>("gi.bounces");
        return references_.of(moving.show(job_.frames), job_.size, bounces, scene_.name);
    }

    void judge(App& app, const FrameScene& frame, const ReferencePair& truth, EstimatePoint point) {
        gi::Technique& technique = gi::technique_of(app, ViewId::first);
        const double start = processor_ms();
        point.estimate = technique.estimate_error();
        point.estimate_ms = processor_ms() - start;
        const auto read = [&](render::Aov aov) { return app.world().resource<Renderer>().frame->read(aov); };
        const Surfaces seen = surfaces_of(frame, read(render::Aov::depth), read(render::Aov::normal));
        point.truth = image_error(read(render::Aov::indirect), truth_at(truth, seen, seen.seen()));
        if (point.estimate.known && is_certain(point.truth)) {
            points_.push_back(std::move(point));
        }
    }

    const MotionScene& scene_;
    const MotionJob& job_;
    ReferencePairs& references_;
    std::vector<EstimatePoint> points_;
};

gi::ErrorTerms terms_of(const EstimatePoint& point, EstimatedFigure figure) {
    const gi::ErrorEstimate& e = point.estimate;
    return gi::error_terms(figure == EstimatedFigure::relrmse ? e.relrmse_parts : e.local_parts, e.photons,
                           e.texels);
}

struct FittedPoint {
    gi::ErrorTerms terms{};
    double truth = 0, weight = 0;

    // ln(truth / estimate).
    double off(const gi::ErrorTerms& weights) const {
        double squared = 1e-12;
        for (std::size_t i = 0; i < terms.size(); ++i) {
            squared += weights[i] * terms[i];
        }
        return std::log(truth) - 0.5 * std::log(squared);
    }
};

double loss(const std::vector<FittedPoint>& points, const gi::ErrorTerms& weights) {
    double sum = 0;
    for (const FittedPoint& point : points) {
        const double off = point.off(weights);
        sum += point.weight * off * off;
    }
    return sum;
}

// One weight after the other by a factor that shrinks, or none of it at all.
gi::ErrorTerms fit_weights(const std::vector<FittedPoint>& points) {
    gi::ErrorTerms best;
    best.fill(1e-4);
    best.front() = 1;
    double least = loss(points, best);
    for (double factor = 16; factor > 1.005; factor = std::sqrt(factor)) {
        bool better = true;
        for (int round = 0; better && round < 200; ++round) {
            better = false;
            for (std::size_t i = 0; i < best.size(); ++i) {
                for (const double value : {best[i] * factor, best[i] / factor, best[i] == 0 ? 1e-4 : 0.0}) {
                    gi::ErrorTerms tried = best;
                    tried[i] = value;
                    const double found = loss(points, tried);
                    if (found < least - 1e-9) {
                        best = tried;
                        least = found;
                        better = true;
                    }
                }
            }
        }
    }
    return best;
}

}  // namespace

double estimated(const EstimatePoint& point, EstimatedFigure figure) {
    return figure == EstimatedFigure::relrmse ? point.estimate.relrmse.value : point.estimate.local.value;
}

double true_error(const EstimatePoint& point, EstimatedFigure figure) {
    return figure == EstimatedFigure::relrmse ? point.truth.relrmse : point.truth.local;
}

std::vector<EstimatePoint> measure_estimates(const MotionScene& scene, const std::vector<MotionCase>& cases,
                                             const MotionJob& job, ReferencePairs& references,
                                             const std::function<void()>& done) {
    Estimates estimates(scene, job, references);
    std::vector<EstimatePoint> all;
    for (const Motion motion : job.motions) {
        for (const MotionCase& one : cases) {
            for (EstimatePoint& point : estimates.measure(motion, one)) {
                all.push_back(std::move(point));
            }
            done();
        }
    }
    references.forget();
    return all;
}

double share_within(const std::vector<EstimatePoint>& points, EstimatedFigure figure, double factor) {
    const auto within = std::ranges::count_if(points, [&](const EstimatePoint& point) {
        const double ratio = estimated(point, figure) / true_error(point, figure);
        return ratio <= factor && ratio >= 1 / factor;
    });
    return points.empty() ? 0 : static_cast<double>(within) / static_cast<double>(points.size());
}

EstimateFit fit_estimates(const std::vector<EstimatePoint>& points, EstimatedFigure figure) {
    std::map<std::string, double> of_scene;
    for (const EstimatePoint& point : points) {
        of_scene[point.scene] += point.held ? 0 : 1;
    }
    std::vector<FittedPoint> fitted;
    for (const EstimatePoint& point : points) {
        if (!point.held) {
            fitted.push_back({terms_of(point, figure), true_error(point, figure), 1 / of_scene[point.scene]});
        }
    }
    EstimateFit fit;
    if (fitted.empty()) {
        return fit;
    }
    fit.weights = fit_weights(fitted);
    std::vector<double> off;
    off.reserve(fitted.size());
    for (const FittedPoint& point : fitted) {
        off.push_back(std::exp(point.off(fit.weights)));
    }
    std::ranges::sort(off);
    const auto at = [&](double share) {
        return off[static_cast<std::size_t>(std::lround(share * static_cast<double>(off.size() - 1)))];
    };
    fit.low = at(0.1);
    fit.high = at(0.9);
    return fit;
}

}  // namespace lanthorn::workbench
