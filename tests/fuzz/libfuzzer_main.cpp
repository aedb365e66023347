// The targets under libFuzzer, which brings main(). LANTHORN_FUZZ_TARGET names one; `tools/fuzz` starts it.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "tests/fuzz/driver.h"
#include "tests/fuzz/target.h"

using namespace lanthorn;
using namespace lanthorn::fuzz;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

const Target& chosen() {
    static const Target* target = chosen_target();
    if (target == nullptr) {
        std::exit(2);
    }
    return *target;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    if (answered(*argc, *argv)) {
        std::exit(0);
    }
    chosen();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        run_target(chosen(), {reinterpret_cast<const char*>(data), size});
    } catch (const std::exception& finding) {
        std::fprintf(stderr, "FINDING: %s\n", finding.what());
        std::abort();
    }
    return 0;
}

// Every other time in the input's own terms, where the target has some.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
    if (chosen().damage != nullptr && seed % 2 == 0) {
        Mutator mutator(seed);
        const std::string damaged = chosen().damage({reinterpret_cast<const char*>(data), size}, mutator);
        if (!damaged.empty() && damaged.size() <= most) {
            std::memcpy(data, damaged.data(), damaged.size());
            return damaged.size();
        }
    }
    return LLVMFuzzerMutate(data, size, most);
}
