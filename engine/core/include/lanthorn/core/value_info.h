// What a value is, for people and for checks: a setting (settings_schema.h) and a component's field
// (lanthorn/ecs/value_type.h) are described by the same type, and messages and tables of both come from it.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lanthorn {

inline constexpr std::array<std::string_view, 4> kPresetNames = {"low", "medium", "high", "ultra"};
// A fifth, beside that scale: every technique as it was published.
inline constexpr std::string_view kPaperPreset = "paper";

struct ValueInfo {
    std::string name;
    std::string unit;   // empty: a plain number
    std::string words;  // one or two sentences for people
    // Of every number in the value; both ends are allowed values, but `lower` if lower_excluded.
    double lower = std::numeric_limits<double>::lowest();
    double upper = std::numeric_limits<double>::max();
    bool lower_excluded = false;
    std::vector<std::string> choices;  // of enumerations: the names of 0, 1, 2, ...
    std::string cost;                  // what a larger value costs: "linear in ms and MB"; empty: nothing
    std::optional<std::array<double, kPresetNames.size()>> preset;  // without: presets leave it alone
    std::optional<double> published;  // of kPaperPreset; without: the default where there are presets

    bool has_range() const;  // one end or both are given
    // False for NaN.
    bool in_range(double number) const {
        return number >= lower && number <= upper && !(lower_excluded && number == lower);
    }
    // For messages: `what` ("a number") and which: "a number from 0 to 3.1 rad", "an integer of 1 or more".
    std::string described(std::string_view what) const;
    // "one of 'march', 'secant'".
    std::string one_of() const;
};

// A cell of a Markdown table: no line ends, no |.
std::string table_cell(std::string_view text);

// Levenshtein's distance: insertions, deletions and substitutions that turn `a` into `b`. O(|a| |b|).
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace lanthorn
