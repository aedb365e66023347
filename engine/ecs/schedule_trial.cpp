#include "engine/ecs/schedule_trial.h"

#include <utility>

namespace lanthorn::ecs {

namespace {

struct Trial {
    std::uint64_t seed = 0;
    std::string left_out;
};

Trial& trial() {
    static Trial all;
    return all;
}

}  // namespace

void shuffle_schedules(std::uint64_t seed) {
    trial().seed = seed;
}

std::uint64_t schedule_seed() {
    return trial().seed;
}

void leave_out_system(std::string name) {
    trial().left_out = std::move(name);
}

const std::string& left_out_system() {
    return trial().left_out;
}

}  // namespace lanthorn::ecs
