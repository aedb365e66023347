#include "tests/fuzz/target.h"

#include <exception>

namespace lanthorn::fuzz {

const Target* find_target(std::string_view name) {
    for (const Target& target : targets()) {
        if (target.name == name) {
            return &target;
        }
    }
    return nullptr;
}

void run_target(const Target& target, std::string_view input) {
    try {
        target.run(input);
    } catch (const Finding&) {
        throw;
    } catch (const std::exception& e) {
        throw Finding(std::string("exception: ") + e.what());
    }
}

}  // namespace lanthorn::fuzz
