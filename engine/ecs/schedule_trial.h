// What tests of tests do to schedules, in the whole process: run in another legal order, and leave a system
// out.
#pragma once

#include <cstdint>
#include <string>

namespace lanthorn::ecs {

// Schedules that are built from now on: of systems that wait for none of each other, `seed` chooses which
// runs first. 0, the default: the one that was added first. What systems declare suffices if every order has
// one result.
void shuffle_schedules(std::uint64_t seed);
std::uint64_t schedule_seed();

// That system does not run, in any schedule, until another name, or none (""), is given here. Between two
// systems, or by one that runs alone.
void leave_out_system(std::string name);
const std::string& left_out_system();

}  // namespace lanthorn::ecs
