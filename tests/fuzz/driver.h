// What both fuzzers answer before they fuzz.
#pragma once

namespace lanthorn::fuzz {

struct Target;

// The one that LANTHORN_FUZZ_TARGET names; null, which is said on standard error, if it names none.
const Target* chosen_target();

// `--targets` prints the names of this program's targets; `--seeds FOLDER` writes the chosen target's sound
// inputs into the folder. Returns whether the arguments were one of these.
bool answered(int argc, char** argv);

}  // namespace lanthorn::fuzz
