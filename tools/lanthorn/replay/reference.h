// The other side of a comparison: who says what a recording's inputs should have led to.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "tools/lanthorn/replay/traced_step.h"

namespace lanthorn::tools {

class Reference {
  public:
    virtual ~Reference() = default;
    // The inputs of a recording played there: with the states that they lead to.
    virtual replay::Recording played(const replay::Recording& inputs) = 0;
    // trace_step() there.
    virtual TracedStep traced(const replay::Recording& inputs, std::uint64_t step,
                              const std::string& after) = 0;
};

// Another build: PROGRAM replay state, once for each answer. Throws Error with what the program says where it
// cannot.
std::unique_ptr<Reference> program_reference(const std::string& program, const std::string& level);

// The same build: with other systems, say (ReplayChoice::extend). `level` must outlive it.
std::unique_ptr<Reference> own_reference(const LevelFile& level, const ReplayChoice& choice);

// Plays the inputs from their beginning and writes down the states.
replay::Recording played_again(const LevelFile& level, const replay::Recording& inputs,
                               const ReplayChoice& choice);

}  // namespace lanthorn::tools
