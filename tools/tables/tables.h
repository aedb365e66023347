// The tables in docs/ that are made from what is declared, components and their fields, settings, and from
// charts.
#pragma once

#include <string>
#include <string_view>

namespace lanthorn::tools {

// Of "components" or "settings", as Markdown. Throws InputError for another name.
std::string table(std::string_view name);

// The page with its tables as they are now: each stands between the lines <!-- table NAME --> and
// <!-- end of NAME -->. Other names are "advice from FILE", what to set for kPageBudgets by a
// trade.csv, and "plan from FILE", what `measure plan --json` printed; FILE as seen from the page, `source`.
// Throws InputError for a page that has none of them, a beginning without an end, or another name.
std::string with_tables(const std::string& page, std::string_view source);

}  // namespace lanthorn::tools
