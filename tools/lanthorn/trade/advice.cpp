#include "tools/lanthorn/trade/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "lanthorn/core/error.h"

namespace lanthorn::tools {

namespace {

// Below it a reference's noise says nothing: an error of 0 would outweigh all other scenes.
constexpr double kLeastError = 1e-6;

double amount(const ChartRow& row, Budget budget) {
    return budget == Budget::ms ? row.ms : row.error;
}

// The rows of each way that was measured in every scene, ways in the order of their first row.
std::vector<std::vector<ChartRow>> by_way(const std::vector<ChartRow>& rows) {
    std::vector<std::vector<ChartRow>> ways;
    std::map<Way, std::size_t> places;
    for (const ChartRow& row : rows) {
        const auto [place, is_new] = places.try_emplace(row.way, ways.size());
        if (is_new) {
            ways.emplace_back();
        }
        ways[place->second].push_back(row);
    }
    const std::size_t scenes = scenes_of(rows).size();
    std::erase_if(ways, [&](const auto& way) { return scenes_of(way).size() < scenes; });
    return ways;
}

// The least limit that `share` of the scenes keep within.
double limit_of(const std::vector<ChartRow>& rows, Budget budget, double share) {
    std::vector<double> amounts;
    for (const ChartRow& row : rows) {
        amounts.push_back(amount(row, budget));
    }
    std::ranges::sort(amounts);
    const auto count = static_cast<double>(amounts.size());
    const auto enough = static_cast<std::size_t>(std::ceil(share * count - 1e-9));
    return amounts[std::clamp<std::size_t>(enough, 1, amounts.size()) - 1];
}

WayFigures figures_of(const std::vector<ChartRow>& rows) {
    WayFigures f;
    f.way = rows.front().way;
    double ms = 0, error = 0;
    for (const ChartRow& row : rows) {
        ms += std::log(std::max(row.ms, kLeastError));
        error += std::log(std::max(row.error, kLeastError));
        if (f.slowest.empty() || row.ms > f.most_ms) {
            f.most_ms = row.ms;
            f.slowest = row.scene;
        }
        if (f.worst.empty() || row.error > f.most_error) {
            f.most_error = row.error;
            f.worst = row.scene;
        }
        f.gpu_mb = std::max(f.gpu_mb, row.gpu_mb);
        f.rss_mb = std::max(f.rss_mb, row.rss_mb);
    }
    const auto count = static_cast<double>(rows.size());
    f.ms = std::exp(ms / count);
    f.error = std::exp(error / count);
    return f;
}

}  // namespace

std::vector<std::string> scenes_of(const std::vector<ChartRow>& rows) {
    std::vector<std::string> scenes;
    for (const ChartRow& row : rows) {
        if (std::ranges::find(scenes, row.scene) == scenes.end()) {
            scenes.push_back(row.scene);
        }
    }
    return scenes;
}

bool has_common_way(const std::vector<ChartRow>& rows) {
    return !by_way(rows).empty();
}

Advice advise(const std::vector<ChartRow>& rows, Budget budget, double limit, double share) {
    const std::vector<std::vector<ChartRow>> ways = by_way(rows);
    if (ways.empty()) {
        throw InputError("trade: the chart's scenes have no technique, preset and settings in common");
    }
    Advice advice;
    advice.limit = limit;
    advice.least = std::numeric_limits<double>::infinity();
    for (const std::vector<ChartRow>& way : ways) {
        const double needs = limit_of(way, budget, share);
        const WayFigures figures = figures_of(way);
        if (needs < advice.least) {
            advice.nearest = figures;
            advice.least = needs;
        }
        const auto other = [&](const WayFigures& f) { return budget == Budget::ms ? f.error : f.ms; };
        if (needs <= limit && (!advice.best || other(figures) < other(*advice.best))) {
            advice.best = figures;
        }
    }
    return advice;
}

std::vector<ChartRow> of_scenes(const std::vector<ChartRow>& rows, const std::vector<std::string>& scenes) {
    const std::vector<std::string> known = scenes_of(rows);
    for (const std::string& scene : scenes) {
        if (std::ranges::find(known, scene) == known.end()) {
            throw InputError(fmt::format("trade: found no scene '{}' in the chart, expected one of {}", scene,
                                         fmt::join(known, ", ")));
        }
    }
    std::vector<ChartRow> result;
    std::ranges::copy_if(rows, std::back_inserter(result), [&](const ChartRow& row) {
        return std::ranges::find(scenes, row.scene) != scenes.end();
    });
    return result;
}

}  // namespace lanthorn::tools
