#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "lanthorn/core/printable.h"
#include "tools/lanthorn/common/svg.h"
#include "tools/lanthorn/trade/label_places.h"
#include "tools/lanthorn/trade/trade_report.h"

namespace lanthorn::tools {

namespace {

// Where a chart's plot lies in it, pixels.
struct Layout {
    double width, height, left, right, top, bottom;
    bool has_legend;  // at its right
};
constexpr Layout kAlone{900, 480, 64, 190, 40, 52, true};
constexpr Layout kPanel{450, 290, 56, 14, 34, 46, false};  // of a page of many
constexpr const char* kColours[] = {"#f28e2b", "#4e79a7", "#59a14f", "#b07aa1", "#e15759",
                                    "#76b7b2", "#9c755f", "#edc948", "#ff9da7", "#8c8c8c"};
constexpr const char* kHollow = "<path class=\"stage\" d=\"M0-6L6 0L0 6L-6 0Z\"/>";

bool is_preset(const TradePoint& point) {
    return point.assignments.empty() || !point.stage.empty();
}

// What marks the presets of a technique.
std::string preset_mark(const std::string& technique) {
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

// How points are marked, the same in all charts of a page.
class Marks {
  public:
    explicit Marks(const std::vector<TradeResult>& results) {
        for (const TradeResult& r : results) {
            if (r.measured() && r.point.technique != "none" && !is_preset(r.point)) {
                const auto [knob, is_new] = knobs_.try_emplace(r.point.knob());
                if (is_new) {
                    knob->second.colour = kColours[(knobs_.size() - 1) % std::size(kColours)];
                }
                knob->second.values.insert(fmt::format("{}", fmt::join(r.point.assignments, ", ")));
            }
        }
    }

    std::string of(const TradePoint& point) const {
        if (is_preset(point)) {
            return point.stage.empty() ? preset_mark(point.technique) : kHollow;
        }
        const char* colour = knobs_.at(point.knob()).colour;
        return point.technique == "path" ? fmt::format("<path d=\"M0-6L6 5H-6Z\" fill=\"{}\"/>", colour)
                                         : fmt::format("<circle r=\"4.5\" fill=\"{}\"/>", colour);
    }

    struct Line {
        std::string mark, text;
    };
    // What is said of these points: the front, techniques, the other final stage, knobs in their order.
    std::vector<Line> legend(const std::vector<const TradeResult*>& shown) const {
        std::vector<Line> lines = {{"<path class=\"front\" d=\"M-7 0H7\"/>", "Pareto front"}};
        if (std::ranges::any_of(shown, [](const TradeResult* r) { return r->figures.seeds > 1; })) {
            lines.push_back({"<path class=\"spread\" d=\"M-3-7H3M0-7V7M-3 7H3\"/>", "all seeds"});
        }
        for (const gi::TechniqueEntry& entry : gi::techniques()) {
            if (entry.has_presets && std::ranges::any_of(shown, [&](const TradeResult* r) {
                    return r->point.technique == entry.name;
                })) {
                lines.push_back({preset_mark(entry.name), entry.name + ", presets"});
            }
        }
        std::set<std::string> said;
        for (const TradeResult* r : shown) {
            if (!r->point.stage.empty() && said.insert("stage").second) {
                lines.push_back({kHollow, "emc, final stage " + r->point.stage});
            }
        }
        for (const TradeResult* r : shown) {
            if (!is_preset(r->point) && said.insert(r->point.knob()).second) {
                const std::string text = words(r->point);
                lines.push_back(
                    {of(r->point), r->point.technique == "path" ? "path tracing: " + text : text});
            }
        }
        return lines;
    }

  private:
    struct Knob {
        const char* colour = nullptr;
        std::set<std::string> values;
    };
    // A knob with one value is that value.
    std::string words(const TradePoint& point) const {
        const std::set<std::string>& values = knobs_.at(point.knob()).values;
        return point.name.empty() && values.size() == 1 ? *values.begin() : point.knob();
    }

    std::map<std::string, Knob> knobs_;
};

class Chart {
  public:
    Chart(const std::vector<TradeResult>& results, const std::string& scene, const TradeMeasure& measure,
          const TradeAxis& axis, const Marks& marks, const Layout& layout)
        : results_(results),
          measure_(measure),
          axis_(axis),
          marks_(marks),
          layout_(layout),
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

    std::string draw(const std::string& title, const std::string& axis_title) const {
        LogRange costs, errors;
        for (const std::size_t i : shown_) {
            costs.add(cost(i));
            errors.add(error(i));
            if (has_spread(i)) {
                errors.add(results_[i].figures.relrmse_least);
                errors.add(results_[i].figures.relrmse_most);
            }
        }
        for (const std::size_t i : none_) {
            errors.add(error(i));
        }
        if (shown_.empty()) {
            return {};
        }
        const LogAxis x = costs.axis(layout_.left, plot_right()), y = errors.axis(plot_bottom(), layout_.top);
        return frame(title, axis_title, x, y) + lines(x, y) + (layout_.has_legend ? legend() : "") +
               marks(x, y);
    }

    std::vector<const TradeResult*> shown() const {
        std::vector<const TradeResult*> list;
        std::ranges::transform(shown_, std::back_inserter(list), [&](std::size_t i) { return &results_[i]; });
        return list;
    }

  private:
    double cost(std::size_t i) const { return results_[i].figures.*axis_.cost; }
    double error(std::size_t i) const { return results_[i].figures.*measure_.error; }
    double plot_right() const { return layout_.width - layout_.right; }
    double plot_bottom() const { return layout_.height - layout_.bottom; }
    // Seeds have the first measure's.
    bool has_spread(std::size_t i) const {
        const TradeFigures& f = results_[i].figures;
        return f.seeds > 1 && measure_.error == &TradeFigures::relrmse && f.relrmse_least > 0;
    }

    std::string frame(const std::string& title, const std::string& axis_title, const LogAxis& x,
                      const LogAxis& y) const {
        const double bottom = plot_bottom();
        std::string svg = fmt::format("<text x=\"{}\" y=\"{}\" class=\"title\">{}</text>\n", layout_.left,
                                      layout_.top - 16, markup_text(title));
        for (const double tick : x.ticks()) {
            svg += fmt::format(
                "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text x=\"{0:.1f}\" y=\"{3}\" "
                "text-anchor=\"middle\">{4:g}</text>\n",
                x(tick), layout_.top, bottom, bottom + 16, tick);
        }
        for (const double tick : y.ticks()) {
            svg += fmt::format(
                "<path class=\"grid\" d=\"M{1} {0:.1f}H{2}\"/><text x=\"{3}\" y=\"{4:.1f}\" "
                "text-anchor=\"end\">{5:g}</text>\n",
                y(tick), layout_.left, plot_right(), layout_.left - 6, y(tick) + 4, tick);
        }
        svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                           0.5 * (layout_.left + plot_right()), bottom + 34, axis_title);
        svg +=
            fmt::format("<text transform=\"translate(16 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                        0.5 * (layout_.top + bottom), measure_.name);
        return svg;
    }

    std::string lines(const LogAxis& x, const LogAxis& y) const {
        std::string svg;
        for (const std::size_t i : none_) {
            svg += fmt::format(
                "<path class=\"none\" d=\"M{} {:.1f}H{}\"/><text x=\"{}\" y=\"{:.1f}\">direct light "
                "alone</text>\n",
                layout_.left, y(error(i)), plot_right(), layout_.left + 6, y(error(i)) - 5);
        }
        std::string path;
        for (const std::size_t i : shown_) {
            if (front_[i]) {
                path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', x(cost(i)), y(error(i)));
            }
        }
        for (const std::size_t i : shown_) {
            if (has_spread(i)) {
                const TradeFigures& f = results_[i].figures;
                svg += fmt::format("<path class=\"spread\" d=\"M{0:.1f} {2:.1f}h6m-3 0V{1:.1f}m-3 0h6\"/>\n",
                                   x(cost(i)) - 3, y(f.relrmse_most), y(f.relrmse_least));
            }
        }
        return svg + fmt::format("<path class=\"front\" d=\"{}\"/>\n", path);
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
            label_places(labels, taken, {{layout_.left + 2, layout_.top}, {plot_right() + 4, plot_bottom()}});
        std::map<std::size_t, LabelPlace> result;
        for (std::size_t i = 0; i < points.size(); ++i) {
            result[points[i]] = places[i];
        }
        return result;
    }

    std::string legend() const {
        std::string svg;
        double at = layout_.top + 8;
        for (const Marks::Line& line : marks_.legend(shown())) {
            svg += fmt::format("<g transform=\"translate({} {})\">{}<text x=\"12\" y=\"4\">{}</text></g>\n",
                               plot_right() + 18, at, line.mark, markup_text(line.text));
            at += 20;
        }
        return svg;
    }

    std::string marks(const LogAxis& x, const LogAxis& y) const {
        std::string svg, presets;
        const std::map<std::size_t, LabelPlace> places = names(x, y);
        for (const std::size_t i : shown_) {
            const TradePoint& point = results_[i].point;
            std::string mark = marks_.of(point);
            const bool preset = is_preset(point);
            if (preset) {
                const LabelPlace& place = places.at(i);
                mark += fmt::format("<text class=\"name\" x=\"{:g}\" y=\"{:g}\"{}>{}</text>", place.from.x,
                                    place.from.y, place.before ? " text-anchor=\"end\"" : "",
                                    markup_text(point.label()));
            }
            (preset ? presets : svg) += fmt::format(
                "<g class=\"point\" data-i=\"{}\" transform=\"translate({:.1f} {:.1f})\"><title>{}: {:.3g} "
                "{}, {} "
                "{:.3g}</title>{}</g>\n",
                i, x(cost(i)), y(error(i)), markup_text(point.label()), cost(i), axis_.name, measure_.name,
                error(i), mark);
        }
        return svg + presets;
    }

    const std::vector<TradeResult>& results_;
    const TradeMeasure& measure_;
    const TradeAxis& axis_;
    const Marks& marks_;
    const Layout& layout_;
    std::vector<bool> front_;
    std::vector<std::size_t> shown_, none_;  // by cost
};

std::string scene_name(const std::vector<TradeResult>& results, const std::string& scene) {
    const auto same = [&](const TradeResult& r) { return r.point.panel() == scene; };
    return std::ranges::find_if(results, same)->point.scene_name();
}

// In as many rows as the page's width makes necessary; moves `top` below them.
std::string legend_in_rows(const std::vector<Marks::Line>& lines, double width, double& top) {
    constexpr double kCharacter = 7, kMark = 40, kRow = 20;
    std::string svg;
    double at = kPanel.left;
    for (const Marks::Line& line : lines) {
        const double takes = kMark + kCharacter * static_cast<double>(line.text.size());
        if (at + takes > width && at > kPanel.left) {
            at = kPanel.left;
            top += kRow;
        }
        svg += fmt::format("<g transform=\"translate({} {})\">{}<text x=\"12\" y=\"4\">{}</text></g>\n", at,
                           top, line.mark, markup_text(line.text));
        at += takes;
    }
    top += kRow + 6;
    return svg;
}

constexpr const char* kStyle =
    "<style>text{font:12px sans-serif;fill:#333}.title{font-weight:bold;font-size:15px}"
    ".grid{stroke:#e4e4e4;fill:none}.front{stroke:#222;stroke-width:1.5;fill:none}"
    ".none{stroke:#999;stroke-dasharray:5 4;fill:none}.preset{stroke:#fff}"
    ".stage{fill:#fff;stroke:#111;stroke-width:2}.spread{stroke:#777;fill:none}"
    ".name{font-weight:bold}.foot{font-size:11px}.point{cursor:pointer}</style>\n";

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
    const Marks marks(results);
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\">\n{}{}</svg>\n",
        kAlone.width, kAlone.height, kAlone.width, kStyle,
        Chart(results, scene, measure, axis, marks, kAlone)
            .draw(fmt::format("{}: {} {}", scene_name(results, scene), measure.name, measure.about),
                  axis.about));
}

std::string trade_svg(const std::vector<TradeResult>& results, const TradeContext& context,
                      TradeDrawing drawing) {
    constexpr double kLine = 17;
    const TradeMeasure& measure = trade_measures().front();
    const Marks marks(results);
    const double width = 2 * kPanel.width;
    const std::size_t axes = drawing == TradeDrawing::time_and_memory ? 2 : 1;
    std::string panels;
    std::vector<const TradeResult*> shown;
    std::size_t count = 0;  // of panels, two a row
    for (const std::string& scene : scenes_of(results)) {
        for (std::size_t a = 0; a < axes; ++a, ++count) {
            const TradeAxis& axis = trade_axes()[a];
            const Chart chart(results, scene, measure, axis, marks, kPanel);
            const std::size_t row = count / 2;
            panels += fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n",
                                  kPanel.width * static_cast<double>(count % 2),
                                  kPanel.height * static_cast<double>(row),
                                  chart.draw(a == 0 ? scene_name(results, scene) : "", axis.name));
            std::ranges::copy(chart.shown(), std::back_inserter(shown));
        }
    }
    const std::size_t rows = (count + 1) / 2;
    double top = kPanel.height * static_cast<double>(rows) + 14;
    std::string foot = legend_in_rows(marks.legend(shown), width, top);
    std::vector<std::string> lines = {fmt::format("{}: {}", measure.name, measure.about)};
    for (std::size_t a = 0; a < axes; ++a) {
        lines.push_back(fmt::format("{}: {}", trade_axes()[a].name, trade_axes()[a].about));
    }
    lines.insert(lines.end(), {context.method, context.reference, context.machine + "; " + context.renderer,
                               context.build});
    for (const std::string& line : lines) {
        foot += fmt::format("<text x=\"{}\" y=\"{}\" class=\"foot\">{}</text>\n", kPanel.left, top,
                            markup_text(line));
        top += kLine;
    }
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
               "height=\"{1}\">\n{2}<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
               width, top, kStyle) +
           panels + foot + "</svg>\n";
}

}  // namespace lanthorn::tools
