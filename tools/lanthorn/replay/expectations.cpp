#include "tools/lanthorn/replay/expectations.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <iterator>
#include <sstream>

#include "game/rules/components.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::tools {

namespace {

template <class Number>
std::optional<Number> number_of(const std::string& word) {
    Number number = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), number);
    return problem == std::errc() && end == word.data() + word.size() ? std::optional(number) : std::nullopt;
}

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream words(line);
    return {std::istream_iterator<std::string>(words), {}};
}

bool is_sign(const std::string& word) {
    return word == "=" || word == "<" || word == ">";
}

ecs::Entity called(const ecs::World& world, const std::string& name) {
    ecs::Entity found = ecs::kNullEntity;
    world.query<ecs::Read<Name>>().each([&](ecs::Entity e, const Name& n) {
        if (found == ecs::kNullEntity && n.value == name) {
            found = e;
        }
    });
    return found;
}

}  // namespace

bool is_told_within(const std::string& line, std::uint64_t steps) {
    const std::vector<std::string> words = words_of(line);
    const std::size_t n = words.size();
    const auto last =
        n >= 3 && words[n - 2] == "before" ? number_of<std::uint64_t>(words[n - 1]) : std::nullopt;
    return last && *last <= steps;
}

Expectations::Expectations(const std::string& file, const std::vector<std::string>& lines) : file_(file) {
    for (const std::string& line : lines) {
        std::vector<std::string> words = words_of(line);
        Expected expected{line};
        const std::size_t n = words.size();
        if (n >= 3 && (words[n - 2] == "before" || words[n - 2] == "after")) {
            (words[n - 2] == "before" ? expected.before : expected.after) =
                number_of<std::uint64_t>(words[n - 1]);
            if (expected.before || expected.after) {
                words.resize(n - 2);
            }
        }
        const bool solved = words.size() == 1 && words[0] == "solved";
        const bool compared = words.size() == 4 && is_sign(words[2]);
        if (!solved && !((compared || words.size() == 2) && words[1].find('.') != std::string::npos)) {
            throw InputError(file, "expectation",
                             fmt::format("found '{}', expected 'solved' or 'ENTITY COMPONENT.FIELD [= < > "
                                         "VALUE]', and then 'before STEP', 'after STEP' or nothing",
                                         line));
        }
        if (!solved) {
            expected.entity = words[0];
            expected.field = words[1];
        }
        if (compared) {
            expected.sign = words[2][0];
            expected.value = words[3];
            if (expected.sign != '=' && !number_of<double>(expected.value)) {
                throw InputError(file, "expectation",
                                 fmt::format("found '{}', expected a number behind {}", line, words[2]));
            }
        }
        expected_.push_back(std::move(expected));
    }
}

bool Expectations::holds(const Expected& expected, const ecs::World& world,
                         const ecs::Registry& registry) const {
    if (expected.entity.empty()) {
        return solved_at_.has_value();
    }
    const auto refuse = [&](const std::string& why) {
        return InputError(file_, fmt::format("expectation '{}'", expected.line), why);
    };
    const ecs::Entity entity = called(world, expected.entity);
    if (entity == ecs::kNullEntity) {
        throw refuse(fmt::format("found no entity called '{}' in the level", expected.entity));
    }
    std::string found;
    try {
        found = ecs::get_json(registry, world, entity, expected.field);
    } catch (const InputError& error) {
        throw refuse(error.what());
    }
    if (expected.value.empty()) {
        if (found != "true" && found != "false") {
            throw refuse(fmt::format("found {}, expected true or false, or '= < > VALUE'", found));
        }
        return found == "true";
    }
    if (expected.sign == '=') {
        return found == expected.value || found == '"' + expected.value + '"';
    }
    const std::optional<double> number = number_of<double>(found);
    if (!number) {
        throw refuse(fmt::format("found {}, expected a number", found));
    }
    const double bound = *number_of<double>(expected.value);
    return expected.sign == '<' ? *number < bound : *number > bound;
}

void Expectations::look(const ecs::World& world, const ecs::Registry& registry, std::uint64_t steps) {
    if (!solved_at_ && game::solved(world)) {
        solved_at_ = steps;
    }
    for (Expected& expected : expected_) {
        if (!expected.at && holds(expected, world, registry)) {
            expected.at = steps;
        }
    }
}

Check Expectations::check() const {
    if (expected_.empty()) {
        return {"expectations", Check::Verdict::none, "nothing is expected"};
    }
    std::vector<std::string> broken, all;
    for (const Expected& one : expected_) {
        all.push_back(fmt::format("{}: {}", one.line, one.at ? fmt::format("at step {}", *one.at) : "never"));
        if (!one.kept()) {
            broken.push_back(all.back());
        }
    }
    return {"expectations", broken.empty() ? Check::Verdict::ok : Check::Verdict::failed,
            fmt::format("{}", fmt::join(broken.empty() ? all : broken, "; "))};
}

}  // namespace lanthorn::tools
