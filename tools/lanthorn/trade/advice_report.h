// Advice in words: as a table for a terminal, as Markdown for a page, as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/lanthorn/trade/advice.h"

namespace lanthorn::tools {

// What is wished of a chart.
struct Wishes {
    std::vector<double> ms;      // limits in milliseconds, each above 0
    std::vector<double> errors;  // limits of relRMSE, each above 0
    double share = 1;            // of the scenes in which a limit must hold, above 0, at most 1

    bool any() const { return !ms.empty() || !errors.empty(); }
};

// Budgets that a page shows: 100, 50, 30 and 20 frames a second, and what a quick laptop has to spare.
inline const std::vector<double> kPageBudgets = {10, 20, 33, 50, 100};
// Of the scenes there: one dear scene does not decide for all.
inline constexpr double kPageShare = 0.75;

// A row a wish for all scenes, and under it, where `by_scene`, what each scene alone would take.
std::string advice_text(const std::vector<ChartRow>& rows, const Wishes& wishes, bool by_scene);
// How such a table is to be read.
std::string reading(const Wishes& wishes);
// One Markdown table, a row a wish, and below it how to read it.
std::string advice_markdown(const std::vector<ChartRow>& rows, const Wishes& wishes);
// An object with a list of wishes.
nlohmann::ordered_json advice_json(const std::vector<ChartRow>& rows, const Wishes& wishes);
// As advice_markdown(), in HTML.
std::string advice_html(const std::vector<ChartRow>& rows, const Wishes& wishes);

// The wishes that no way keeps within, a line each; empty: all are met.
std::string unmet(const std::vector<ChartRow>& rows, const Wishes& wishes);

}  // namespace lanthorn::tools
