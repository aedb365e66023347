// Commands that a hand might give, drawn by a number.
#pragma once

#include <cstdint>
#include <string>

#include "tools/editor/core/edit_model.h"

namespace lanthorn::testing_tools {

// Numbers of a fixed sequence: the same on every machine.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next();
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
    double between(double low, double high);

  private:
    std::uint64_t state_;
};

// One line, of a node or material of the model. Now and then one that is refused.
std::string random_command(const editor::EditModel& model, Dice& dice);

}  // namespace lanthorn::testing_tools
