#include "tools/lanthorn/replay/expectations.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <sstream>

#include "game/rules/components.h"
#include "lanthorn/core/error.h"

namespace lanthorn::tools {

namespace {

std::optional<std::uint64_t> number_of(const std::string& word) {
    std::uint64_t number = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), number);
    return problem == std::errc() && end == word.data() + word.size() ? std::optional(number) : std::nullopt;
}

}  // namespace

Expectations::Expectations(const std::string& file, std::vector<std::string> lines) {
    for (std::string& line : lines) {
        std::istringstream words(line);
        std::string what, when, number, rest;
        words >> what >> when >> number;
        const std::optional<std::uint64_t> step = number_of(number);
        const bool timed = (when == "before" || when == "after") && step;
        if (what != "solved" || !(when.empty() || timed) || words >> rest) {
            throw InputError(
                file, "expectation",
                fmt::format("found '{}', expected 'solved', 'solved before STEP' or 'solved after "
                            "STEP'",
                            line));
        }
        Expected expected{std::move(line), {}, {}};
        (when == "before" ? expected.before : expected.after) = step;
        expected_.push_back(std::move(expected));
    }
}

void Expectations::look(const ecs::World& world, std::uint64_t steps) {
    if (!solved_at_ && game::solved(world)) {
        solved_at_ = steps;
    }
}

Check Expectations::check() const {
    if (expected_.empty()) {
        return {"expectations", Check::Verdict::none, "nothing is expected"};
    }
    const std::string found = solved_at_ ? fmt::format("solved at step {}", *solved_at_) : "not solved";
    std::vector<std::string> broken, all;
    for (const Expected& one : expected_) {
        all.push_back(one.line);
        if (!solved_at_ || (one.before && *solved_at_ >= *one.before) ||
            (one.after && *solved_at_ <= *one.after)) {
            broken.push_back(one.line);
        }
    }
    const bool holds = broken.empty();
    return {"expectations", holds ? Check::Verdict::ok : Check::Verdict::failed,
            fmt::format("{} (expected: {})", found, fmt::join(holds ? all : broken, ", "))};
}

}  // namespace lanthorn::tools
