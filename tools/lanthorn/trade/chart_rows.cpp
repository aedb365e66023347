#include "tools/lanthorn/trade/chart_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>

#include "lanthorn/core/error.h"

namespace lanthorn::tools {

namespace {

// The next record of RFC 4180 text, which loses it.
std::vector<std::string> take_record(std::string_view& text) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    std::size_t i = 0;
    for (; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
            fields.back() += c;
            ++i;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (!quoted && c == ',') {
            fields.emplace_back();
        } else if (!quoted && c == '\n') {
            ++i;
            break;
        } else if (quoted || c != '\r') {
            fields.back() += c;
        }
    }
    text.remove_prefix(i);
    return fields;
}

// A finite number of 0 or more, and nothing else.
std::optional<double> amount(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(value) && value >= 0 ? std::optional(value) : std::nullopt;
}

// The columns of a chart by name.
class Columns {
  public:
    Columns(const std::vector<std::string>& heading, const std::string& source) : source_(source) {
        for (std::size_t i = 0; i < heading.size(); ++i) {
            places_[heading[i]] = i;
        }
        for (const char* name : {"scene", "technique", "preset", "settings", "cost_ms", "relrmse"}) {
            if (!places_.contains(name)) {
                throw InputError(source, "line 1",
                                 fmt::format("has no column '{}', expected a trade.csv", name));
            }
        }
    }

    std::size_t count() const { return places_.size(); }
    const std::string& text(const std::vector<std::string>& record, const std::string& name) const {
        return record[places_.at(name)];
    }
    double number(const std::vector<std::string>& record, const std::string& name, std::size_t line) const {
        const std::string& found = text(record, name);
        if (const auto value = amount(found)) {
            return *value;
        }
        throw InputError(source_, fmt::format("line {}, {}", line, name),
                         fmt::format("found '{}', expected a number of 0 or more", found));
    }
    double number_or_0(const std::vector<std::string>& record, const std::string& name,
                       std::size_t line) const {
        return places_.contains(name) ? number(record, name, line) : 0;
    }

  private:
    std::string source_;
    std::map<std::string, std::size_t> places_;
};

}  // namespace

std::string Way::options() const {
    std::string text = "--technique " + technique + " --preset " + preset;
    for (std::size_t start = 0; start < settings.size();) {
        const std::size_t end = std::min(settings.find(' ', start), settings.size());
        text += " --set " + settings.substr(start, end - start);
        start = end + 1;
    }
    return text;
}

std::vector<ChartRow> chart_rows(const std::vector<TradeResult>& results) {
    std::vector<ChartRow> rows;
    for (const TradeResult& r : results) {
        if (r.measured()) {
            const TradePoint& p = r.point;
            rows.push_back({p.scene_name(),
                            {p.technique, p.preset, fmt::format("{}", fmt::join(p.assignments, " "))},
                            r.figures.cost_ms,
                            r.figures.relrmse,
                            r.figures.gpu_mb,
                            r.figures.rss_mb});
        }
    }
    return rows;
}

std::vector<ChartRow> parse_chart(std::string_view csv, const std::string& source) {
    const Columns columns(take_record(csv), source);
    std::vector<ChartRow> rows;
    for (std::size_t line = 2; !csv.empty(); ++line) {
        const std::vector<std::string> record = take_record(csv);
        if (record.size() != columns.count()) {
            throw InputError(source, fmt::format("line {}", line),
                             fmt::format("has {} fields, expected {}", record.size(), columns.count()));
        }
        if (columns.text(record, "cost_ms").empty()) {
            continue;  // a point that was lost
        }
        rows.push_back({columns.text(record, "scene"),
                        {columns.text(record, "technique"), columns.text(record, "preset"),
                         columns.text(record, "settings")},
                        columns.number(record, "cost_ms", line),
                        columns.number(record, "relrmse", line),
                        columns.number_or_0(record, "gpu_mb", line),
                        columns.number_or_0(record, "rss_mb", line)});
    }
    if (rows.empty()) {
        throw InputError(source, "", "has no measured point");
    }
    return rows;
}

std::vector<ChartRow> read_chart(const std::filesystem::path& file_or_folder) {
    const bool folder = std::filesystem::is_directory(file_or_folder);
    const std::filesystem::path file = folder ? file_or_folder / "trade.csv" : file_or_folder;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw InputError(file.string(), "",
                         "cannot be opened, expected the CSV that lanthorn trade writes, or its folder");
    }
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    return parse_chart(text, file.string());
}

}  // namespace lanthorn::tools
