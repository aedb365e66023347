#include "tests/bench/vertex-map/line_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lanthorn/core/atomic_file.h"

namespace lanthorn::bench {

namespace {

constexpr double kWidth = 720, kHeight = 420, kLeft = 70, kRight = 262, kTop = 46, kBottom = 54;
constexpr std::array<const char*, 10> kColours = {"#1b6ca8", "#c0392b", "#2e8b57", "#8e44ad", "#b8860b",
                                                  "#555555", "#17a2a2", "#e377c2", "#7f3f00", "#9acd32"};

struct Axis {
    double low, high, from, to;  // values and where they are drawn
    double at(double value) const {
        return from + (to - from) * std::log(value / low) / std::log(high / low);
    }
};

// About values more than 0, to whole powers of ten where `decades`.
Axis axis_of(double low, double high, bool decades, double from, double to) {
    if (decades) {
        low = std::pow(10, std::floor(std::log10(low)));
        high = std::pow(10, std::ceil(std::log10(high)));
    }
    return {low, std::max(high, low * 1.01), from, to};
}

}  // namespace

void write_svg(const Chart& chart, const std::filesystem::path& path) {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const ChartLine& line : chart.lines) {
        for (const double value : line.values) {
            low = value > 0 ? std::min(low, value) : low;
            high = std::max(high, value);
        }
    }
    for (const ChartMark& mark : chart.marks) {
        low = std::min(low, mark.value);
        high = std::max(high, mark.value);
    }
    const Axis x = axis_of(chart.x.front(), chart.x.back(), false, kLeft, kWidth - kRight);
    const Axis y = axis_of(low, high, true, kHeight - kBottom, kTop);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"white\"/>\n"
        "<text x=\"{2}\" y=\"24\" font-size=\"15\">{3}</text>\n",
        kWidth, kHeight, kLeft, chart.title);
    for (double tick = y.low; tick < y.high * 1.001; tick *= 10) {
        svg += fmt::format(
            "<line x1=\"{0}\" y1=\"{2:.1f}\" x2=\"{1}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>"
            "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g}</text>\n",
            kLeft, kWidth - kRight, y.at(tick), kLeft - 6, y.at(tick) + 4, tick);
    }
    for (const double tick : chart.x) {
        svg += fmt::format(
            "<line x1=\"{0:.1f}\" y1=\"{1}\" x2=\"{0:.1f}\" y2=\"{2}\" stroke=\"#eee\"/>"
            "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:g}</text>\n",
            x.at(tick), kTop, kHeight - kBottom, kHeight - kBottom + 18, tick);
    }
    svg += fmt::format(
        "<text x=\"{0}\" y=\"{1}\" text-anchor=\"middle\">{2}</text>\n"
        "<text transform=\"translate(18 {3}) rotate(-90)\" text-anchor=\"middle\">{4}</text>\n",
        (kLeft + kWidth - kRight) / 2, kHeight - 12, chart.x_name, (kTop + kHeight - kBottom) / 2,
        chart.y_name);
    double legend = kTop + 10;
    const auto entry = [&](const std::string& name, const char* colour, const char* dashes) {
        svg += fmt::format(
            "<line x1=\"{0}\" y1=\"{1}\" x2=\"{2}\" y2=\"{1}\" stroke=\"{3}\" stroke-width=\"2\"{4}/>"
            "<text x=\"{5}\" y=\"{6}\">{7}</text>\n",
            kWidth - kRight + 14, legend - 4, kWidth - kRight + 38, colour, dashes, kWidth - kRight + 44,
            legend, name);
        legend += 18;
    };
    for (std::size_t i = 0; i < chart.lines.size(); ++i) {
        const char* colour = kColours[i % kColours.size()];
        std::string points;
        for (std::size_t k = 0; k < chart.x.size(); ++k) {
            const double value = chart.lines[i].values[k];
            if (value > 0) {
                const double px = x.at(chart.x[k]), py = y.at(value);
                points += fmt::format("{:.1f},{:.1f} ", px, py);
                svg +=
                    fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>", px, py, colour);
            }
        }
        svg += fmt::format("\n<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n",
                           points, colour);
        entry(chart.lines[i].name, colour, "");
    }
    for (const ChartMark& mark : chart.marks) {
        const char* dashes = " stroke-dasharray=\"6 4\"";
        svg += fmt::format("<line x1=\"{}\" y1=\"{:.1f}\" x2=\"{}\" y2=\"{:.1f}\" stroke=\"black\"{}/>\n",
                           kLeft, y.at(mark.value), kWidth - kRight, y.at(mark.value), dashes);
        entry(mark.name, "black", dashes);
    }
    write_file(path, svg + "</svg>\n");
}

void write_csv(const Chart& chart, const std::filesystem::path& path) {
    std::string csv = chart.x_name;
    for (const ChartLine& line : chart.lines) {
        csv += ',' + line.name;
    }
    for (std::size_t k = 0; k < chart.x.size(); ++k) {
        csv += fmt::format("\n{:g}", chart.x[k]);
        for (const ChartLine& line : chart.lines) {
            csv += fmt::format(",{:.4f}", line.values[k]);
        }
    }
    write_file(path, csv + '\n');
}

}  // namespace lanthorn::bench
