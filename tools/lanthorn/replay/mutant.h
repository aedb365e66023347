// Faults that a replay is made with, to see whether its verification notices: the suite's own test.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/runtime/app.h"

namespace lanthorn::tools {

// "flip:door@412#1a2b": a fault of a kind, in a part or system, in a step, with a number that chooses what is
// left open (hexadecimal, may be missing).
struct Mutant {
    enum class Kind {
        flip,   // one bit of one field of a part: of a component of some entity, or of a resource
        swap,   // two entities exchange a component
        skip,   // a system of the fixed schedule does not run
        drop,   // the step's input is lost; the first step from there on that has one
        watch,  // no fault: tells which parts each system changes in the step
        crash,  // a real SIGSEGV
        hang,   // no step any more
        flaky,  // like flip, but only in a suite's first run of a recording
    };
    Kind kind = Kind::flip;
    std::string name;
    std::uint64_t step = 0;  // from 0
    std::uint64_t number = 0;
};

// Throws InputError for what is none: kind, step and number; whether there is such a part or system shows in
// the App.
Mutant parse_mutant(std::string_view text);

// What came of it.
struct MutantReport {
    bool made = false;
    std::uint64_t step = 0;          // at which it was made
    std::vector<std::string> parts;  // of the state, that it altered; empty for what shows later in the step
    std::string words;               // "bit 0 of angle of entity 12v1"
    std::map<std::string, std::vector<std::string>> systems;  // of watch: parts that each changed
};
nlohmann::ordered_json report_json(const MutantReport& report);

// Makes it in an App that has all its components and systems and no step yet; lasts as long as the App's
// steps. The report is filled when the step comes. Throws InputError for a part or system that there is not.
std::shared_ptr<const MutantReport> plant(const Mutant& mutant, App& app);

}  // namespace lanthorn::tools
