// Numbers as options take several.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lanthorn::workbench {

// "1.5,-2,3e1": finite numbers with commas between them and nothing else; none for any other text.
std::optional<std::vector<double>> comma_numbers(const std::string& text);

}  // namespace lanthorn::workbench
