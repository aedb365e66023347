#include "tools/lanthorn/measure/budget_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "lanthorn/core/printable.h"

namespace lanthorn::tools {

namespace {

constexpr double kStripWidth = 960, kStripLeft = 64, kStripRight = 16, kStrip = 150, kStripGap = 34,
                 kStripTop = 44;
constexpr std::size_t kTold = 24;  // decisions

struct Strip {
    double top = 0, high = 1;  // pixels; what its upper edge stands for
    std::size_t frames = 1;

    double x(std::size_t frame) const {
        return kStripLeft + (kStripWidth - kStripLeft - kStripRight) * static_cast<double>(frame) /
                                static_cast<double>(frames);
    }
    double y(double value) const { return top + kStrip * (1 - std::clamp(value / high, 0.0, 1.0)); }
    std::string level(double value, const std::string& text, const char* style) const {
        return fmt::format(
            "<path class=\"{}\" d=\"M{} {:.1f}H{}\"/><text x=\"{}\" y=\"{:.1f}\" "
            "text-anchor=\"end\">{}</text>\n",
            style, kStripLeft, y(value), kStripWidth - kStripRight, kStripLeft - 5, y(value) + 4, text);
    }
    // Steps, one a frame.
    std::string line(const std::function<double(std::size_t)>& value, const char* colour) const {
        std::string path;
        for (std::size_t i = 0; i < frames; ++i) {
            path += fmt::format("{}{:.1f} {:.1f}H{:.1f}", i == 0 ? 'M' : 'L', x(i), y(value(i)), x(i + 1));
        }
        return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"/>\n", path,
                           colour);
    }
    std::string title(const std::string& text) const {
        return fmt::format("<text x=\"{}\" y=\"{}\" class=\"strip\">{}</text>\n", kStripLeft, top - 6, text);
    }
};

std::string parts(const BudgetRecord& record, const Strip& strip, double height) {
    std::string svg;
    const auto shade = [&](bool BudgetFrame::*what, const char* colour) {
        for (std::size_t i = 0; i < record.frames.size(); ++i) {
            if (record.frames[i].*what) {
                std::size_t end = i;
                while (end < record.frames.size() && record.frames[end].*what) {
                    ++end;
                }
                svg +=
                    fmt::format("<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n",
                                strip.x(i), kStripTop, strip.x(end) - strip.x(i), height, colour);
                i = end;
            }
        }
    };
    shade(&BudgetFrame::moves, "#eef3fa");
    shade(&BudgetFrame::core, "#f7dfc4");
    return svg;
}

// Of the frames that are `moves` and `core`; none: nothing.
std::string part_text(const BudgetRecord& record, double budget, const char* what, bool moves, bool core) {
    BudgetRecord part;
    std::ranges::copy_if(record.frames, std::back_inserter(part.frames), [&](const BudgetFrame& frame) {
        return frame.moves == moves && frame.core == core;
    });
    return part.frames.empty() ? std::string()
                               : fmt::format("{}: {:.0f} % used, 95th percentile {:.2f}\n", what,
                                             100 * part.mean(0) / budget, part.percentile(0.95, 0) / budget);
}

}  // namespace

std::string budget_csv(const BudgetRecord& record) {
    std::string csv = "frame,ms,error,scale,rung,moves,core\n";
    for (std::size_t i = 0; i < record.frames.size(); ++i) {
        const BudgetFrame& f = record.frames[i];
        csv += fmt::format("{},{:.6g},{},{:.3g},{},{},{}\n", i, f.ms,
                           f.error ? fmt::format("{:.6g}", *f.error) : "", f.scale, f.rung, f.moves ? 1 : 0,
                           f.core ? 1 : 0);
    }
    return csv;
}

std::string budget_svg(const BudgetRecord& record, const BudgetRunJob& job, const std::string& title) {
    const std::vector<BudgetFrame>& frames = record.frames;
    const double budget = job.wish.ms;
    double most = 0.01;
    for (const BudgetFrame& f : frames) {
        most = std::max(most, 1.2 * f.error.value_or(0));
    }
    const Strip ms{kStripTop, budget > 0 ? 2.5 * budget : 1.1 * record.percentile(1, 0), frames.size()};
    const Strip error{kStripTop + kStrip + kStripGap, most, frames.size()};
    const Strip spared{kStripTop + 2 * (kStrip + kStripGap), 1, frames.size()};
    const double rungs = std::max<double>(1, static_cast<double>(record.outcome.ladder.size() - 1));
    const double strips = 3 * kStrip + 2 * kStripGap;
    const std::size_t told = std::min(record.outcome.steps.size(), kTold);
    const double height = kStripTop + strips + 40 + 16 * static_cast<double>(told);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
        "<style>text{{font:12px sans-serif;fill:#333}}.title{{font-weight:bold;font-size:15px}}"
        ".strip{{font-weight:bold}}.grid{{stroke:#ddd;fill:none}}.wish{{stroke:#d62728;fill:none}}"
        ".edge{{stroke:#d62728;stroke-dasharray:4 4;fill:none}}.step{{stroke:#555;stroke-dasharray:2 "
        "3;fill:none}}"
        "</style>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
        kStripWidth, height);
    svg += parts(record, ms, strips);
    svg += fmt::format("<text x=\"{}\" y=\"18\" class=\"title\">{}</text>\n", kStripLeft, markup_text(title));
    svg += ms.title(job.wish.processor ? "milliseconds of processor time" : "milliseconds");
    for (const double share : {0.5, 1.0, 1.5, 2.0, 2.5}) {
        svg += ms.level(share * ms.high / 2.5, fmt::format("{:.3g}", share * ms.high / 2.5), "grid");
    }
    if (budget > 0) {
        svg += ms.level(budget, "", "wish") + ms.level(1.1 * budget, "", "edge");
    }
    svg += ms.line([&](std::size_t i) { return frames[i].ms; }, "#1f4e8c");
    svg += error.title("estimated relRMSE");
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
        svg += error.level(share * most, fmt::format("{:.2g}", share * most), "grid");
    }
    if (job.wish.error > 0) {
        svg += error.level(job.wish.error, "", "wish");
    }
    svg += error.line([&](std::size_t i) { return frames[i].error.value_or(0); }, "#2c7a3f");
    svg += spared.title("what is left of the ladder (black), of the picture's pixels (orange)");
    for (const double share : {0.0, 0.5, 1.0}) {
        svg += spared.level(share, fmt::format("{:.0f} %", 100 * share), "grid");
    }
    svg +=
        spared.line([&](std::size_t i) { return 1 - static_cast<double>(frames[i].rung) / rungs; }, "#111");
    svg += spared.line([&](std::size_t i) { return frames[i].scale * frames[i].scale; }, "#e07b00");
    double y = kStripTop + strips + 32;
    for (std::size_t k = 0; k < told; ++k) {
        const BudgetStep& step = record.outcome.steps[k];
        const double x = ms.x(static_cast<std::size_t>(step.frame));
        svg += fmt::format(
            "<path class=\"step\" d=\"M{0:.1f} {1}V{2}\"/><text x=\"{0:.1f}\" y=\"{3}\" "
            "text-anchor=\"middle\">{4}</text>\n<text x=\"{5}\" y=\"{6}\">{4}: frame {7}, {8}: {9}</text>\n",
            x, kStripTop, kStripTop + strips, kStripTop + strips + 13, k + 1, kStripLeft, y, step.frame,
            markup_text(step.name), markup_text(step.why));
        y += 16;
    }
    return svg + "</svg>\n";
}

std::string budget_text(const BudgetRecord& record, const BudgetRunJob& job) {
    const std::size_t from = std::min<std::size_t>(10, record.frames.size() / 2);
    std::string text =
        fmt::format("median {:.1f} ms, 95th percentile {:.1f}, mean {:.1f}, from frame {} on\n",
                    record.percentile(0.5, from), record.percentile(0.95, from), record.mean(from), from);
    if (job.wish.ms > 0) {
        text +=
            fmt::format("{:.0f} % of the budget used, 95th percentile {:.2f} of it\n",
                        100 * record.mean(from) / job.wish.ms, record.percentile(0.95, from) / job.wish.ms);
    }
    if (job.wish.ms > 0) {
        text += part_text(record, job.wish.ms, "at rest", false, false) +
                part_text(record, job.wish.ms, "in motion", true, false) +
                part_text(record, job.wish.ms, "in motion, beside another program", true, true);
    }
    text += record.outcome.verdict + '\n';
    for (const BudgetStep& step : record.outcome.steps) {
        text += fmt::format("frame {}: rung {} to {}, {}: {}\n", step.frame, step.from, step.to, step.name,
                            step.why);
    }
    return text;
}

}  // namespace lanthorn::tools
