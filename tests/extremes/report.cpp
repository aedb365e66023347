#include "tests/extremes/report.h"
#include "lanthorn/emc/emc_statistics.h"

#include <fmt/format.h>

#include <algorithm>

namespace lanthorn::extremes {

namespace {

struct Line {
    std::string name;
    std::string text;
    double of_error_bound = 0;  // 0 for known defects
};

std::vector<Line>& lines() {
    static std::vector<Line> all;
    return all;
}

std::string remark(const Row& row) {
    std::string text = row.reason;
    for (const Defect& defect : row.defects) {
        text += fmt::format("{}DEFECT: {}", text.empty() ? "" : "; ", defect.why);
    }
    return text;
}

}  // namespace

void report(const Row& row, const Outcome& o) {
    const double ratio = o.ordinary_error > 0 ? o.off.rel_rmse / o.ordinary_error : 0;
    lines().push_back(
        {row.name,
         fmt::format("{:<34} {:>7.4f} {:>6.2f} {:>6.2f} {:>7.4f} {:>6.3f} {:>8.1e} {:>6.4f} {:>7.4f} "
                     "{:>5.2f} {:>7.4f} {:>4} {:>4} {}",
                     row.name, o.off.rel_rmse, ratio, row.error, o.off.flux_ratio, row.flux, o.unlike,
                     o.gained, o.lost, o.off.dark, o.off.leak, o.statistics.of<gi::EmcStatistics>().k,
                     o.not_finite + o.replaced, remark(row)),
         row.defects.empty() ? ratio / row.error : 0});
}

void print_table() {
    fmt::print("{:<34} {:>7} {:>6} {:>6} {:>7} {:>6} {:>8} {:>6} {:>7} {:>5} {:>7} {:>4} {:>4} {}\n", "row",
               "relRMSE", "x ord.", "bound", "flux", "bound", "unlike", "energy", "lost", "dark", "leak", "k",
               "NaN", "why a bound is another, or broken");
    for (const Line& line : lines()) fmt::print("{}\n", line.text);
    const auto worst = std::ranges::max_element(lines(), {}, &Line::of_error_bound);
    if (worst != lines().end()) {
        fmt::print("nearest its bound of error: {} ({:.2f} of it)\n", worst->name, worst->of_error_bound);
    }
}

}  // namespace lanthorn::extremes
