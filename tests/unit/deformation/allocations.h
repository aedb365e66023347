// Counts every operator new of this program.
#pragma once

#include <cstdint>

namespace deformation_test {

std::uint64_t allocations();

}  // namespace deformation_test
