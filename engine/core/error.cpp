#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {
std::string join(std::string_view file, std::string_view place, std::string_view problem) {
    std::string line(file);
    if (!place.empty()) {
        line.append(": ").append(place);
    }
    return line.append(": ").append(problem);
}
}  // namespace

InputError::InputError(std::string_view file, std::string_view place, std::string_view problem)
    : Error(ExitCode::bad_input, join(file, place, problem)) {}

}  // namespace lanthorn
