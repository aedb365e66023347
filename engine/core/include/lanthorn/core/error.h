// Errors that a person can act on: one line that says what, where, and what was expected.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace lanthorn {

// Process exit codes, the same for every program of the project.
enum class ExitCode : int {
    ok = 0,
    check_failed = 1,  // a comparison or verification did not hold
    bad_input = 2,     // bad usage or bad input
    no_gl = 3,         // no usable OpenGL 4.5
    not_judged = 4,    // nothing failed, but not all could be judged: a node was lost, a time limit
};

// Thrown for everything a user can correct. `what()` is one line without a trailing newline.
// Broken invariants of our own are assertions, not this.
class Error : public std::runtime_error {
  public:
    Error(ExitCode code, const std::string& line) : std::runtime_error(line), code_(code) {}
    ExitCode code() const noexcept { return code_; }  // that the program ends with

  private:
    ExitCode code_;
};

// Bad input: "FILE: PLACE: PROBLEM" (PLACE may be empty), at most 500 bytes, control characters written out.
// PROBLEM says what was found and what was expected.
class InputError : public Error {
  public:
    InputError(std::string_view file, std::string_view place, std::string_view problem);
    // Bad usage without a file: an argument or a setting.
    explicit InputError(std::string_view line);
};

}  // namespace lanthorn
