// A chart of lines as an SVG: what grows with what.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lanthorn::bench {

struct ChartLine {
    std::string name;
    std::vector<double> values;  // by x
};

// A number that somebody else has stated: a dashed line across the chart.
struct ChartMark {
    std::string name;
    double value = 0;
};

struct Chart {
    std::string title;
    std::string x_name, y_name;
    std::vector<double> x;  // more than 0, ascending
    std::vector<ChartLine> lines;
    std::vector<ChartMark> marks;
};

// Both axes logarithmic. Writes the file whole or not at all; throws Error.
void write_svg(const Chart& chart, const std::filesystem::path& path);
// A column a line, x first.
void write_csv(const Chart& chart, const std::filesystem::path& path);

}  // namespace lanthorn::bench
