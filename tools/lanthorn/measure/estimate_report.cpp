#include "tools/lanthorn/measure/estimate_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/core/printable.h"
#include "tools/lanthorn/common/svg.h"
#include "tools/lanthorn/common/text_table.h"
#include "tools/workbench/scene/median.h"

namespace lanthorn::tools {

namespace {

constexpr EstimatedFigure kFigures[] = {EstimatedFigure::relrmse, EstimatedFigure::local};
constexpr const char* kFigureNames[] = {"relRMSE", "local error"};
constexpr double kWithin = 1.5;

constexpr double kSide = 400, kLeft = 60, kTop = 40, kGap = 70, kFoot = 96;
constexpr const char* kFittedColour = "#4e79a7";
constexpr const char* kHeldColour = "#e15759";

bool is_still(const EstimatePoint& point) {
    return point.motion == "first" || point.motion == "rest";
}

// The presets in the order of their first points.
std::vector<std::string> cases_of(const std::vector<EstimatePoint>& points) {
    std::vector<std::string> cases;
    for (const EstimatePoint& point : points) {
        if (std::ranges::find(cases, point.of) == cases.end()) {
            cases.push_back(point.of);
        }
    }
    return cases;
}

std::string mark_of(const EstimatePoint& point, std::size_t preset) {
    static constexpr const char* kShapes[] = {"M-4-4H4V4H-4Z", "M0-5L5 0L0 5L-5 0Z", "M0-5L5 4H-5Z",
                                              "M-5 0L-2.5-4.4H2.5L5 0L2.5 4.4H-2.5Z"};
    const char* colour = point.held ? kHeldColour : kFittedColour;
    return fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"{}\"/>", kShapes[preset % std::size(kShapes)],
                       is_still(point) ? colour : "#fff", colour);
}

std::string panel(const std::vector<EstimatePoint>& points, EstimatedFigure figure, double left,
                  const char* name) {
    LogRange range;
    for (const EstimatePoint& point : points) {
        range.add(true_error(point, figure));
        range.add(estimated(point, figure));
    }
    const LogAxis x = range.axis(left, left + kSide), y = range.axis(kTop + kSide, kTop);
    std::string svg = fmt::format("<text x=\"{}\" y=\"24\" class=\"title\">{}</text>\n", left, name);
    for (const double tick : x.ticks()) {
        svg += fmt::format(
            "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text x=\"{0:.1f}\" y=\"{3}\" "
            "text-anchor=\"middle\">{4:g}</text>\n<path class=\"grid\" d=\"M{5} {6:.1f}H{7}\"/><text "
            "x=\"{8}\" "
            "y=\"{9:.1f}\" text-anchor=\"end\">{4:g}</text>\n",
            x(tick), kTop, kTop + kSide, kTop + kSide + 16, tick, left, y(tick), left + kSide, left - 6,
            y(tick) + 4);
    }
    const double low = range.low / 1.15, high = range.high * 1.15;
    svg += fmt::format(
        "<path class=\"band\" d=\"M{0:.1f} {1:.1f}L{2:.1f} {3:.1f}H{4:.1f}V{5:.1f}L{6:.1f} "
        "{7:.1f}H{0:.1f}Z\"/>\n",
        x(low), y(kWithin * low), x(high / kWithin), y(high), x(high), y(high / kWithin), x(kWithin * low),
        y(low));
    svg += fmt::format("<path class=\"band\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", x(low), y(low), x(high),
                       y(high));
    const std::vector<std::string> cases = cases_of(points);
    for (const EstimatePoint& point : points) {
        const auto preset = static_cast<std::size_t>(std::ranges::find(cases, point.of) - cases.begin());
        svg += fmt::format(
            "<g transform=\"translate({:.1f} {:.1f})\"><title>{}, {}, {}: {:.3g}, estimated "
            "{:.3g}</title>{}</g>\n",
            x(true_error(point, figure)), y(estimated(point, figure)), markup_text(point.scene),
            markup_text(point.of), point.motion, true_error(point, figure), estimated(point, figure),
            mark_of(point, preset));
    }
    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">true, against path</text>\n",
                       left + 0.5 * kSide, kTop + kSide + 34);
    return svg + fmt::format(
                     "<text transform=\"translate({} {}) rotate(-90)\" "
                     "text-anchor=\"middle\">estimated</text>\n",
                     left - 44, kTop + 0.5 * kSide);
}

std::string legend(const std::vector<EstimatePoint>& points) {
    const std::vector<std::string> cases = cases_of(points);
    std::string svg;
    double x = kLeft;
    const double y = kTop + kSide + 60;
    const auto entry = [&](const EstimatePoint& like, std::size_t preset, const std::string& words) {
        svg += fmt::format("<g transform=\"translate({} {})\">{}<text x=\"12\" y=\"4\">{}</text></g>\n", x, y,
                           mark_of(like, preset), markup_text(words));
        x += 40 + 6.5 * static_cast<double>(words.size());
    };
    EstimatePoint like;
    like.motion = "rest";
    for (std::size_t i = 0; i < cases.size(); ++i) {
        entry(like, i, cases[i]);
    }
    entry(like, 0, "scenes that the weights were fitted to");
    like.held = true;
    entry(like, 0, "held-out scenes");
    like.motion = "lamp";
    entry(like, 0, "in motion");
    return svg;
}

std::vector<EstimatePoint> chosen(const std::vector<EstimatePoint>& points, bool held, bool still) {
    std::vector<EstimatePoint> result;
    std::ranges::copy_if(points, std::back_inserter(result), [&](const EstimatePoint& point) {
        return point.held == held && is_still(point) == still;
    });
    return result;
}

}  // namespace

std::string estimate_csv(const std::vector<EstimatePoint>& points) {
    std::string csv =
        "scene,held,case,motion,relrmse,relrmse_sigma,estimate,low,high,local,local_sigma,local_estimate,"
        "local_low,local_high,noise,blur,bend,contrast,unknown,local_noise,local_blur,local_bend,"
        "local_contrast,local_unknown,photons,texels,estimate_ms,gi_ms\n";
    for (const EstimatePoint& p : points) {
        const gi::ErrorEstimate& e = p.estimate;
        csv += fmt::format("{},{},{},{}", p.scene, p.held ? 1 : 0, p.of, p.motion);
        for (const double number : {p.truth.relrmse,
                                    p.truth.relrmse_sigma,
                                    e.relrmse.value,
                                    e.relrmse.low,
                                    e.relrmse.high,
                                    p.truth.local,
                                    p.truth.local_sigma,
                                    e.local.value,
                                    e.local.low,
                                    e.local.high,
                                    e.relrmse_parts.noise,
                                    e.relrmse_parts.blur,
                                    e.relrmse_parts.bend,
                                    e.relrmse_parts.contrast,
                                    e.relrmse_parts.unknown,
                                    e.local_parts.noise,
                                    e.local_parts.blur,
                                    e.local_parts.bend,
                                    e.local_parts.contrast,
                                    e.local_parts.unknown,
                                    e.photons,
                                    e.texels,
                                    p.estimate_ms,
                                    p.gi_ms}) {
            csv += fmt::format(",{:.6g}", number);
        }
        csv += '\n';
    }
    return csv;
}

std::string estimate_svg(const std::vector<EstimatePoint>& points) {
    if (points.empty()) {
        return "<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n";
    }
    const double width = kLeft + 2 * kSide + kGap + 20, height = kTop + kSide + kFoot;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
        "<style>text{{font:12px sans-serif;fill:#333}}.title{{font-weight:bold;font-size:15px}}"
        ".grid{{stroke:#e4e4e4;fill:none}}.band{{fill:#888;fill-opacity:.12;stroke:#888}}</style>\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
        width, height);
    for (std::size_t i = 0; i < std::size(kFigures); ++i) {
        svg += panel(points, kFigures[i], kLeft + static_cast<double>(i) * (kSide + kGap), kFigureNames[i]);
    }
    return svg + legend(points) + "</svg>\n";
}

std::string estimate_table(const std::vector<EstimatePoint>& points) {
    TextTable table({"figure", "scenes", "points", "within 1.25", "within 1.5", "within 2", "in the interval",
                     "estimate / truth"});
    for (std::size_t i = 0; i < std::size(kFigures); ++i) {
        for (const bool held : {false, true}) {
            for (const bool still : {true, false}) {
                const std::vector<EstimatePoint> some = chosen(points, held, still);
                if (some.empty()) {
                    continue;
                }
                std::vector<double> ratios;
                double inside = 0;
                for (const EstimatePoint& p : some) {
                    const double truth = true_error(p, kFigures[i]);
                    const gi::EstimatedError& e = i == 0 ? p.estimate.relrmse : p.estimate.local;
                    ratios.push_back(e.value / truth);
                    inside += truth >= e.low && truth <= e.high ? 1 : 0;
                }
                const auto share = [&](double factor) {
                    return fmt::format("{:.0f} %", 100 * share_within(some, kFigures[i], factor));
                };
                table.add({kFigureNames[i],
                           fmt::format("{}, {}", held ? "held" : "fitted", still ? "at rest" : "in motion"),
                           std::to_string(some.size()), share(1.25), share(1.5), share(2),
                           fmt::format("{:.0f} %", 100 * inside / static_cast<double>(some.size())),
                           fmt::format("{:.2f}", median(ratios))});
            }
        }
    }
    std::vector<double> cost, gi;
    for (const EstimatePoint& p : points) {
        if (p.motion != "first") {
            cost.push_back(p.estimate_ms);
        }
        gi.push_back(p.gi_ms);
    }
    return table.text() +
           fmt::format("estimate: {:.2f} ms of processor time, median; the frames' indirect light {:.1f}\n",
                       median(cost), median(gi));
}

std::string fit_text(const std::vector<EstimatePoint>& points) {
    std::string text;
    for (std::size_t i = 0; i < std::size(kFigures); ++i) {
        const EstimateFit fit = fit_estimates(points, kFigures[i]);
        text += fmt::format("{}: {{{{{:.3g}}}, {:.2f}, {:.2f}}}\n", kFigureNames[i],
                            fmt::join(fit.weights, ", "), fit.low, fit.high);
    }
    return text;
}

}  // namespace lanthorn::tools
