// Target `gltf`: the importer, and what is made of a scene after it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/mutation.h"

namespace lanthorn::fuzz {

// Imports the bytes, as .glb if they begin like one, else as .gltf; expects a scene that satisfies every
// invariant and plays.
void read_gltf(std::string_view input);
std::vector<std::string> gltf_inputs();
// Damages one to three values of the JSON, whatever container it is in.
std::string damage_gltf(const std::string& input, Mutator& mutator);

}  // namespace lanthorn::fuzz
