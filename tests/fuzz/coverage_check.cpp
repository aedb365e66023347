// Whether coverage tells ways apart, where it is compiled as tools/fuzz compiles it: exit code 0 if so.
#include <cstdio>

#include "tests/fuzz/coverage.h"

namespace {

using namespace lanthorn::fuzz;

volatile int sink = 0;

void take(int way) {
    if (way > 3) {
        sink = 2;
    } else if (way == 2) {
        sink = 7;
    }
}

bool is_new(CoverageMap& seen, int way) {
    begin_coverage();
    take(way);
    return add_coverage(seen);
}

}  // namespace

int main() {
    static CoverageMap seen;
    // A first way, the same once more, two others, and one of them again.
    const bool right =
        is_new(seen, 0) && !is_new(seen, 0) && is_new(seen, 2) && is_new(seen, 9) && !is_new(seen, 2);
    if (!right) {
        std::fputs("ways are not told apart\n", stderr);
    }
    return right ? 0 : 1;
}
