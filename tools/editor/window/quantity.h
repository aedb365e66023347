// Numbers as people type them: 1.5*2, 45deg, 800lm, 2700K.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lanthorn::edit_window {

// What was typed: a value and the unit behind it, "" where there is none.
struct Quantity {
    double value = 0;
    std::string unit;
};

// Sums, products and brackets of decimal numbers, then a unit in letters; blanks anywhere. Nothing for what
// is no such text or gives no finite number.
std::optional<Quantity> typed_quantity(std::string_view text);
// The same in the `unit` of a field: deg and rad, mm, cm and km are converted; any other unit but its own is
// refused.
std::optional<double> typed_number(std::string_view text, std::string_view unit);

// As a field shows it: at most `digits` significant digits, no more than it needs.
std::string shown_number(double value, int digits = 5);

}  // namespace lanthorn::edit_window
