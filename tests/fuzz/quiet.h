// What a program's main() prints, taken aside.
#pragma once

#include <string>

namespace lanthorn::fuzz {

// While it lives, standard output goes nowhere and standard error is caught. What sanitizers report still
// arrives.
class Quiet {
  public:
    Quiet();
    ~Quiet();
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

    std::string errors() const;  // so far

  private:
    int out_, err_, caught_;
};

}  // namespace lanthorn::fuzz
