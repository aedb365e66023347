// The tables in docs/ that are made from what is declared: components and their fields, settings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lanthorn::tools {

// "components", "settings".
std::vector<std::string_view> table_names();

// As Markdown. Throws InputError for a name that is none of these.
std::string table(std::string_view name);

// The page with its tables as they are now: each stands between the lines <!-- table NAME --> and
// <!-- end of NAME -->. Throws InputError for a page that has none of them, or a beginning without an end.
std::string with_tables(const std::string& page, std::string_view source);

}  // namespace lanthorn::tools
