// Numbers that are unique in the process: DeformedMesh::version and RefinedTopology::serial.
#pragma once

#include <cstdint>

namespace lanthorn::deform {

// Never 0. One thread that calls in a fixed order gets the same order of numbers in every run.
std::uint64_t next_serial();

}  // namespace lanthorn::deform
