#include "tests/fuzz/driver.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

#include "tests/fuzz/target.h"

namespace lanthorn::fuzz {

const Target* chosen_target() {
    const char* name = std::getenv("LANTHORN_FUZZ_TARGET");
    const Target* target = find_target(name == nullptr ? "" : name);
    if (target == nullptr) {
        std::fputs("LANTHORN_FUZZ_TARGET: expected a name that --targets prints\n", stderr);
    }
    return target;
}

bool answered(int argc, char** argv) {
    const std::string_view asked = argc > 1 ? argv[1] : "";
    if (asked == "--targets") {
        for (const Target& target : targets()) {
            std::printf("%s\n", std::string(target.name).c_str());
        }
        return true;
    }
    const Target* target = asked == "--seeds" && argc > 2 ? chosen_target() : nullptr;
    if (target == nullptr) {
        return false;
    }
    int number = 0;
    for (const std::string& seed : target->seeds()) {
        const std::string path = std::string(argv[2]) + "/seed-" + std::to_string(number++);
        std::ofstream(path, std::ios::binary).write(seed.data(), static_cast<std::streamsize>(seed.size()));
    }
    return true;
}

}  // namespace lanthorn::fuzz
