// A finished chart, read back: what trade.csv holds, as far as advice wants to know it.
#pragma once

#include <compare>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/workbench/trade_point.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {

// What a user sets: a technique, a preset, and settings over it.
struct Way {
    std::string technique, preset;
    std::string settings;  // "KEY=VALUE KEY=VALUE"; empty: the preset as it is

    auto operator<=>(const Way&) const = default;
    // As the command line takes it: "--technique emc --preset low --set KEY=VALUE".
    std::string options() const;
};

// One way in one scene, measured.
struct ChartRow {
    std::string scene;
    Way way;
    double ms = 0;      // cost_ms
    double error = 0;   // relrmse
    double gpu_mb = 0;  // 0: the chart does not say
    double rss_mb = 0;  // 0: the chart does not say
};

// The measured points of a chart, in its order.
std::vector<ChartRow> chart_rows(const std::vector<TradeResult>& results);

// The same of the text of a trade.csv (RFC 4180); columns are found by their names. Throws InputError, which
// names `source` and the line, for text that is no such table or has no measured point.
std::vector<ChartRow> parse_chart(std::string_view csv, const std::string& source);

// parse_chart() of a CSV file, or of the trade.csv in a folder. Throws InputError for what cannot be read.
std::vector<ChartRow> read_chart(const std::filesystem::path& file_or_folder);

}  // namespace lanthorn::tools
