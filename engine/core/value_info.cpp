#include "lanthorn/core/value_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lanthorn {

namespace {

// An end of a range: whole numbers in full, others to seven digits.
std::string end_text(double number) {
    const bool whole = std::abs(number) < 1e15 && number == std::floor(number);
    return whole ? fmt::format("{:.0f}", number) : fmt::format("{:.7g}", number);
}

}  // namespace

bool ValueInfo::has_range() const {
    return lower != std::numeric_limits<double>::lowest() || upper != std::numeric_limits<double>::max();
}

std::string ValueInfo::described(std::string_view what) const {
    const bool low = lower > std::numeric_limits<double>::lowest();
    const bool high = upper < std::numeric_limits<double>::max();
    std::string text(what);
    if (low && high) {
        text += lower_excluded ? fmt::format(" more than {}, at most {}", end_text(lower), end_text(upper))
                               : fmt::format(" from {} to {}", end_text(lower), end_text(upper));
    } else if (low) {
        text += lower_excluded ? fmt::format(" more than {}", end_text(lower))
                               : fmt::format(" of {} or more", end_text(lower));
    } else if (high) {
        text += fmt::format(" of at most {}", end_text(upper));
    }
    return unit.empty() ? text : text + " " + unit;
}

std::string ValueInfo::one_of() const {
    std::string names;
    for (const std::string& choice : choices) {
        names += (names.empty() ? "one of '" : ", '") + choice + "'";
    }
    return names;
}

std::string table_cell(std::string_view text) {
    std::string cell;
    for (const char c : text) {
        if (c == '|') {
            cell += '\\';
        }
        cell += c == '\n' ? ' ' : c;
    }
    return cell;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, substituted});
        }
    }
    return row.back();
}

}  // namespace lanthorn
