// Misuse of the ECS by the program: dead entities, missing components, structural changes while iterating,
// schedules that cannot be ordered. One line (a schedule's report may have several) naming what is concerned.
#pragma once

#include <stdexcept>
#include <string>

namespace lanthorn::ecs {

class Error : public std::logic_error {
  public:
    explicit Error(const std::string& line) : std::logic_error(line) {}
};

}  // namespace lanthorn::ecs
