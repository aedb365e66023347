#include "tools/workbench/scene/comma_numbers.h"

#include <charconv>
#include <cmath>

namespace lanthorn::workbench {

std::optional<std::vector<double>> comma_numbers(const std::string& text) {
    std::vector<double> numbers;
    const char* at = text.data();
    const char* end = at + text.size();
    while (true) {
        double number = 0;
        const auto [rest, problem] = std::from_chars(at, end, number);
        if (problem != std::errc() || !std::isfinite(number)) {
            return std::nullopt;
        }
        numbers.push_back(number);
        if (rest == end) {
            return numbers;
        }
        if (*rest != ',') {
            return std::nullopt;
        }
        at = rest + 1;
    }
}

}  // namespace lanthorn::workbench
