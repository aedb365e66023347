#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tools/lanthorn/common/svg.h"
#include "tools/lanthorn/trade/label_places.h"
#include "tools/lanthorn/trade/trade_report.h"

namespace lanthorn::tools {

namespace {

constexpr double kWidth = 900, kHeight = 480;
constexpr double kLeft = 64, kRight = 190, kTop = 40, kBottom = 52;
constexpr const char* kColours[] = {"#f28e2b", "#4e79a7", "#59a14f", "#b07aa1", "#e15759",
                                    "#76b7b2", "#9c755f", "#edc948", "#ff9da7", "#8c8c8c"};

class Chart {
  public:
    Chart(const std::vector<TradeResult>& results, const std::string& scene, const TradeMeasure& measure,
          const TradeAxis& axis)
        : results_(results),
          measure_(measure),
          axis_(axis),
          front_(pareto_front(results, measure.error, axis.cost)) {
        for (std::size_t i = 0; i < results.size(); ++i) {
            const TradeResult& r = results[i];
            if (!r.measured() || r.point.panel() != scene || !(error(i) > 0) || !(cost(i) > 0)) {
                continue;
            }
            (r.point.technique == "none" ? none_ : shown_).push_back(i);
        }
        std::ranges::sort(shown_, {}, [&](std::size_t i) { return cost(i); });
    }

    std::string draw(const std::string& title) const {
        LogRange costs, errors;
        for (const std::size_t i : shown_) {
            costs.add(cost(i));
            errors.add(error(i));
        }
        for (const std::size_t i : none_) {
            errors.add(error(i));
        }
        if (shown_.empty()) {
            return {};
        }
        const LogAxis x = costs.axis(kLeft, kWidth - kRight), y = errors.axis(kHeight - kBottom, kTop);
        return frame(title, x, y) + lines(x, y) + marks(x, y);
    }

  private:
    // What marks the presets of a technique.
    static std::string preset_mark(const std::string& technique) {
        struct Mark {
            const char* path;
            const char* colour;
        };
        // emc, then in the order in which techniques were made known.
        static constexpr Mark kMarks[] = {{"M0-7L7 0L0 7L-7 0Z", "#111"},
                                          {"M-6-6H6V6H-6Z", "#d62728"},
                                          {"M0-7L6.7-2.2L4.1 5.7H-4.1L-6.7-2.2Z", "#1f77b4"},
                                          {"M-7 0L-3.5-6H3.5L7 0L3.5 6H-3.5Z", "#2ca02c"},
                                          {"M-2-7H2V-2H7V2H2V7H-2V2H-7V-2H-2Z", "#9467bd"}};
        std::size_t index = 0;
        for (const gi::TechniqueEntry& entry : gi::techniques()) {
            if (entry.name == technique) {
                break;
            }
            index += entry.has_presets ? 1 : 0;
        }
        const Mark& mark = kMarks[index % std::size(kMarks)];
        return fmt::format("<path class=\"preset\" d=\"{}\" fill=\"{}\"/>", mark.path, mark.colour);
    }
    double cost(std::size_t i) const { return results_[i].figures.*axis_.cost; }
    double error(std::size_t i) const { return results_[i].figures.*measure_.error; }

    std::string frame(const std::string& title, const LogAxis& x, const LogAxis& y) const {
        std::string svg =
            fmt::format("<text x=\"{}\" y=\"24\" class=\"title\">{}</text>\n", kLeft, xml_text(title));
        for (const double tick : x.ticks()) {
            svg += fmt::format(
                "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text x=\"{0:.1f}\" y=\"{3}\" "
                "text-anchor=\"middle\">{4:g}</text>\n",
                x(tick), kTop, kHeight - kBottom, kHeight - kBottom + 16, tick);
        }
        for (const double tick : y.ticks()) {
            svg += fmt::format(
                "<path class=\"grid\" d=\"M{1} {0:.1f}H{2}\"/><text x=\"{3}\" y=\"{4:.1f}\" "
                "text-anchor=\"end\">{5:g}</text>\n",
                y(tick), kLeft, kWidth - kRight, kLeft - 6, y(tick) + 4, tick);
        }
        svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                           0.5 * (kLeft + kWidth - kRight), kHeight - 14, axis_.about);
        svg +=
            fmt::format("<text transform=\"translate(16 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                        0.5 * (kTop + kHeight - kBottom), measure_.name);
        return svg;
    }

    std::string lines(const LogAxis& x, const LogAxis& y) const {
        std::string svg;
        for (const std::size_t i : none_) {
            svg += fmt::format(
                "<path class=\"none\" d=\"M{} {:.1f}H{}\"/><text x=\"{}\" y=\"{:.1f}\">direct light "
                "alone</text>\n",
                kLeft, y(error(i)), kWidth - kRight, kLeft + 6, y(error(i)) - 5);
        }
        std::string path;
        for (const std::size_t i : shown_) {
            if (front_[i]) {
                path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', x(cost(i)), y(error(i)));
            }
        }
        return svg + fmt::format("<path class=\"front\" d=\"{}\"/>\n", path);
    }

    static bool is_preset(const TradePoint& point) {
        return point.assignments.empty() || !point.stage.empty();
    }

    // By point: where a preset's name stands.
    std::map<std::size_t, LabelPlace> names(const LogAxis& x, const LogAxis& y) const {
        std::vector<ChartLabel> labels;
        std::vector<std::size_t> points;
        std::vector<ChartBox> taken;
        for (const std::size_t i : shown_) {
            const glm::dvec2 at(x(cost(i)), y(error(i)));
            taken.push_back({at - 7.0, at + 7.0});
            if (is_preset(results_[i].point)) {
                labels.push_back({at, results_[i].point.label()});
                points.push_back(i);
            }
        }
        const std::vector<LabelPlace> places =
            label_places(labels, taken, {{kLeft + 2, kTop}, {kWidth - kRight + 4, kHeight - kBottom}});
        std::map<std::size_t, LabelPlace> result;
        for (std::size_t i = 0; i < points.size(); ++i) {
            result[points[i]] = places[i];
        }
        return result;
    }

    std::string marks(const LogAxis& x, const LogAxis& y) const {
        std::string svg, presets;
        std::map<std::string, const char*> colours;
        double legend = kTop + 8;
        const auto legend_line = [&](const std::string& mark, const std::string& text) {
            svg += fmt::format("<g transform=\"translate({} {})\">{}<text x=\"12\" y=\"4\">{}</text></g>\n",
                               kWidth - kRight + 18, legend, mark, xml_text(text));
            legend += 20;
        };
        legend_line("<path class=\"front\" d=\"M-7 0H7\"/>", "Pareto front");
        for (const gi::TechniqueEntry& entry : gi::techniques()) {
            if (entry.has_presets && std::ranges::any_of(shown_, [&](std::size_t i) {
                    return results_[i].point.technique == entry.name;
                })) {
                legend_line(preset_mark(entry.name), entry.name + ", presets");
            }
        }
        constexpr const char* kHollow = "<path class=\"stage\" d=\"M0-6L6 0L0 6L-6 0Z\"/>";
        const auto other =
            std::ranges::find_if(shown_, [&](std::size_t i) { return !results_[i].point.stage.empty(); });
        if (other != shown_.end()) {
            legend_line(kHollow, "emc, final stage " + results_[*other].point.stage);
        }
        const std::map<std::size_t, LabelPlace> places = names(x, y);
        for (const std::size_t i : shown_) {
            const TradePoint& point = results_[i].point;
            const std::string knob = point.knob();
            std::string mark = point.stage.empty() ? preset_mark(point.technique) : kHollow;
            const bool preset = is_preset(point);
            if (!preset) {
                const auto [colour, is_new] =
                    colours.try_emplace(knob, kColours[colours.size() % std::size(kColours)]);
                mark = point.technique == "path"
                           ? fmt::format("<path d=\"M0-6L6 5H-6Z\" fill=\"{}\"/>", colour->second)
                           : fmt::format("<circle r=\"4.5\" fill=\"{}\"/>", colour->second);
                if (is_new) {
                    legend_line(mark, point.technique == "path" ? "path tracing: " + knob : knob);
                }
            } else {
                const LabelPlace& place = places.at(i);
                mark += fmt::format("<text class=\"name\" x=\"{:g}\" y=\"{:g}\"{}>{}</text>", place.from.x,
                                    place.from.y, place.before ? " text-anchor=\"end\"" : "",
                                    xml_text(point.label()));
            }
            (preset ? presets : svg) += fmt::format(
                "<g class=\"point\" data-i=\"{}\" transform=\"translate({:.1f} {:.1f})\"><title>{}: {:.3g} "
                "{}, {} "
                "{:.3g}</title>{}</g>\n",
                i, x(cost(i)), y(error(i)), xml_text(point.label()), cost(i), axis_.name, measure_.name,
                error(i), mark);
        }
        return svg + presets;
    }

    const std::vector<TradeResult>& results_;
    const TradeMeasure& measure_;
    const TradeAxis& axis_;
    std::vector<bool> front_;
    std::vector<std::size_t> shown_, none_;  // by cost
};

std::string scene_name(const std::vector<TradeResult>& results, const std::string& scene) {
    const auto same = [&](const TradeResult& r) { return r.point.panel() == scene; };
    return std::ranges::find_if(results, same)->point.scene_name();
}

constexpr const char* kStyle =
    "<style>text{font:12px sans-serif;fill:#333}.title{font-weight:bold;font-size:15px}"
    ".grid{stroke:#e4e4e4;fill:none}.front{stroke:#222;stroke-width:1.5;fill:none}"
    ".none{stroke:#999;stroke-dasharray:5 4;fill:none}.preset{stroke:#fff}"
    ".stage{fill:#fff;stroke:#111;stroke-width:2}"
    ".name{font-weight:bold}.point{cursor:pointer}</style>\n";

}  // namespace

const std::vector<TradeAxis>& trade_axes() {
    static const std::vector<TradeAxis> axes = {
        {"ms",
         "cost of the indirect light of a frame, ms (software rasteriser: processor time of all threads)",
         &TradeFigures::cost_ms},
        {"GPU MB", "buffers and textures of the renderer, MB", &TradeFigures::gpu_mb},
        {"process MB", "most memory of the process, MB", &TradeFigures::rss_mb}};
    return axes;
}

const std::vector<TradeMeasure>& trade_measures() {
    static const std::vector<TradeMeasure> measures = {
        {"relRMSE", "of the indirect irradiance, against the same number of bounces", &TradeFigures::relrmse},
        {"relRMSE, all bounces", "of the indirect irradiance, against all bounces there are",
         &TradeFigures::relrmse_all},
        {"FLIP", "of the final picture, against all bounces there are", &TradeFigures::flip}};
    return measures;
}

std::vector<std::string> scenes_of(const std::vector<TradeResult>& results) {
    std::vector<std::string> scenes;
    for (const TradeResult& r : results) {
        if (std::ranges::find(scenes, r.point.panel()) == scenes.end()) {
            scenes.push_back(r.point.panel());
        }
    }
    return scenes;
}

std::string trade_chart(const std::vector<TradeResult>& results, const std::string& scene,
                        const TradeMeasure& measure, const TradeAxis& axis) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\">\n{}{}</svg>\n", kWidth,
        kHeight, kWidth, kStyle,
        Chart(results, scene, measure, axis)
            .draw(fmt::format("{}: {} {}", scene_name(results, scene), measure.name, measure.about)));
}

std::string trade_svg(const std::vector<TradeResult>& results, const TradeContext& context) {
    constexpr double kFoot = 80;
    const TradeMeasure& measure = trade_measures().front();
    const std::vector<std::string> scenes = scenes_of(results);
    const double height = kHeight * static_cast<double>(scenes.size()) + kFoot;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n{2}"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
        kWidth, height, kStyle);
    double top = 0;
    for (const std::string& scene : scenes) {
        svg += fmt::format(
            "<g transform=\"translate(0 {})\">\n{}</g>\n", top,
            Chart(results, scene, measure, trade_axes().front())
                .draw(fmt::format("{}: {} {}", scene_name(results, scene), measure.name, measure.about)));
        top += kHeight;
    }
    for (const std::string& line :
         {context.method, context.reference, context.machine + "; " + context.renderer, context.build}) {
        svg += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", kLeft, top += 17, xml_text(line));
    }
    return svg + "</svg>\n";
}

}  // namespace lanthorn::tools
