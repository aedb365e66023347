// What is fuzzed: each target is one thing that reads what strangers bring.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/mutation.h"

namespace lanthorn::fuzz {

// Something that must not happen for any input. Crashes and what sanitizers report need no such words.
class Finding : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

struct Target {
    std::string_view name;   // also of its folder of seeds
    std::string_view about;  // for people
    // Reads the input as a program would. Refusals are fine, and are checked for their form; throws Finding,
    // or anything else that is none, where a promise is broken.
    void (*run)(std::string_view input);
    // Sound inputs, a few, to begin with.
    std::vector<std::string> (*seeds)();
    // Damages the input in its own terms (a value of its JSON, say); returns nothing if it has none. May be
    // null: bytes alone.
    std::string (*damage)(const std::string& input, Mutator& mutator);
};

// Of this program: lanthorn_fuzz has those of files, lanthorn_fuzz_programs those of the programs around
// them.
std::span<const Target> targets();

// The one of that name, or null.
const Target* find_target(std::string_view name);

// Runs it; whatever is no refusal becomes a Finding.
void run_target(const Target& target, std::string_view input);

}  // namespace lanthorn::fuzz
