#include "lanthorn/core/error.h"

#include <algorithm>

#include "lanthorn/core/printable.h"

namespace lanthorn {

namespace {

constexpr std::size_t kLine = 500, kPlace = 160, kLeastProblem = 200;  // bytes

// What would not be one line of plain text is written out (printable.h). The problem is cut so that the line
// has at most 500 bytes, or 200 of its own where file and place leave less.
std::string join(std::string_view file, std::string_view place, std::string_view problem) {
    std::string line = printable(file);
    if (!place.empty()) {
        line.append(": ").append(shortened(printable(place), kPlace));
    }
    line.append(": ");
    const std::size_t left = line.size() < kLine ? kLine - line.size() : 0;
    return line.append(shortened(printable(problem), std::max(left, kLeastProblem)));
}

}  // namespace

InputError::InputError(std::string_view file, std::string_view place, std::string_view problem)
    : Error(ExitCode::bad_input, join(file, place, problem)) {}

}  // namespace lanthorn
