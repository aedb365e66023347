#include "lanthorn/core/error.h"

#include <algorithm>

#include "lanthorn/core/printable.h"

namespace lanthorn {

namespace {

constexpr std::size_t kLine = 500, kPlace = 130, kProblem = 200;  // bytes

// What would not be one line of plain text is written out (printable.h), and the line cut to 500 bytes: a
// place to 130, then a file to its last bytes so that 200 are left for the problem, which has what is left.
std::string join(std::string_view file, std::string_view place, std::string_view problem) {
    const std::string text = printable(problem);
    std::string rest = place.empty() ? ": " : ": " + shortened(printable(place), kPlace) + ": ";
    std::string line =
        shortened_front(printable(file), kLine - rest.size() - std::min(text.size(), kProblem));
    line += rest;
    return line.append(shortened(text, kLine - line.size()));
}

}  // namespace

InputError::InputError(std::string_view file, std::string_view place, std::string_view problem)
    : Error(ExitCode::bad_input, join(file, place, problem)) {}

InputError::InputError(std::string_view line)
    : Error(ExitCode::bad_input, shortened(printable(line), kLine)) {}

}  // namespace lanthorn
