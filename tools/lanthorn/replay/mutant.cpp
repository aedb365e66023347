#include "tools/lanthorn/replay/mutant.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/ecs/schedule_trial.h"
#include "game/rules/player_input.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/world_hash.h"
#include "tools/lanthorn/replay/mutant_values.h"

namespace lanthorn::tools {

namespace {

constexpr std::array<std::string_view, 8> kKinds = {"flip",  "swap",  "skip", "drop",
                                                    "watch", "crash", "hang", "flaky"};

bool is_number(std::string_view text, int base, std::uint64_t& to) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), to, base);
    return error == std::errc() && end == text.data() + text.size();
}

std::vector<std::string> differing(const App& app, const std::vector<std::uint64_t>& before) {
    const std::vector<std::uint64_t> now = ecs::state_hashes(app.registry(), app.world());
    const std::vector<std::string> parts = ecs::state_parts(app.registry());
    std::vector<std::string> names;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (now[i] != before[i]) {
            names.push_back(parts[i]);
        }
    }
    return names;
}

// A bug as there are: it writes where nothing is.
[[gnu::noinline]] void write_nowhere() {
    volatile int* volatile nowhere = nullptr;
    *nowhere = 1;
}

[[noreturn, gnu::noinline]] void never_end() {
    for (volatile int turns = 0;;) {
        turns = turns + 1;
    }
}

bool first_run() {
    const char* run = std::getenv("LANTHORN_REPLAY_RUN");
    return run == nullptr || std::string_view(run) == "1";
}

// After the step's systems, before its state is hashed.
void at_end(const Mutant& mutant, App& app, MutantReport& report) {
    const std::vector<std::uint64_t> before = ecs::state_hashes(app.registry(), app.world());
    switch (mutant.kind) {
        case Mutant::Kind::crash:
            write_nowhere();
            break;
        case Mutant::Kind::hang:
            never_end();
        case Mutant::Kind::swap:
            report.words = swap_two(app.registry(), app.world(), mutant.name, mutant.number);
            break;
        default:
            report.words = flip_bit(app.registry(), app.world(), mutant.name, mutant.number);
    }
    report.parts = differing(app, before);
    report.made = !report.parts.empty();
}

void drop_input(const Mutant& mutant, ecs::World& world, std::uint64_t step, MutantReport& report) {
    auto& input = world.resource_mut<game::PlayerInput>();
    if (report.made || step < mutant.step || (input.yaw == 0 && input.pitch == 0)) {
        return;
    }
    report.made = true;
    report.step = step;
    report.words = fmt::format("forward {}, right {}, yaw {}, pitch {}, held {}", input.forward, input.right,
                               input.yaw, input.pitch, input.held);
    input = {};
}

void watch(App& app, std::shared_ptr<MutantReport> report) {
    auto before =
        std::make_shared<std::vector<std::uint64_t>>(ecs::state_hashes(app.registry(), app.world()));
    app.fixed_schedule().watch([&app, report, before](const std::string& system, bool, const ecs::World&) {
        for (std::string& part : differing(app, *before)) {
            report->systems[system].push_back(std::move(part));
        }
        *before = ecs::state_hashes(app.registry(), app.world());
    });
}

}  // namespace

Mutant parse_mutant(std::string_view text) {
    const auto refuse = [&] {
        return InputError(fmt::format(
            "--mutant: found '{}', expected KIND:NAME@STEP#NUMBER as in flip:door@412#1a2b; kinds "
            "are flip, swap, skip, drop, watch, crash, hang and flaky",
            text));
    };
    Mutant mutant;
    const std::size_t at = text.rfind('@');
    if (at == std::string_view::npos) {
        throw refuse();
    }
    const std::string_view what = text.substr(0, at), when = text.substr(at + 1);
    const std::string_view kind = what.substr(0, what.find(':'));
    const auto found = std::ranges::find(kKinds, kind);
    const std::string_view step = when.substr(0, when.find('#'));
    if (found == kKinds.end() || !is_number(step, 10, mutant.step) ||
        (step.size() < when.size() && !is_number(when.substr(step.size() + 1), 16, mutant.number))) {
        throw refuse();
    }
    mutant.kind = static_cast<Mutant::Kind>(found - kKinds.begin());
    mutant.name = what.substr(std::min(kind.size() + 1, what.size()));
    return mutant;
}

nlohmann::ordered_json report_json(const MutantReport& report) {
    return {{"made", report.made},
            {"step", report.step},
            {"parts", report.parts},
            {"words", report.words},
            {"systems", report.systems}};
}

std::shared_ptr<const MutantReport> plant(const Mutant& mutant, App& app) {
    const auto report = std::make_shared<MutantReport>();
    report->step = mutant.step;
    const bool of_part = mutant.kind == Mutant::Kind::flip || mutant.kind == Mutant::Kind::swap ||
                         mutant.kind == Mutant::Kind::flaky;
    if (of_part && !has_part(app.registry(), mutant.name)) {
        throw InputError(fmt::format("--mutant: found no part of the state called '{}'", mutant.name));
    }
    if (mutant.kind == Mutant::Kind::flaky && !first_run()) {
        return report;
    }
    ecs::Schedule& fixed = app.fixed_schedule();
    if (mutant.kind == Mutant::Kind::skip) {
        const std::vector<std::string> order = fixed.order();
        if (std::ranges::find(order, mutant.name) == order.end()) {
            throw InputError(fmt::format("--mutant: found no system of a step called '{}'", mutant.name));
        }
    }
    const auto now = [](const ecs::World& world) { return world.resource<Time>().steps - 1; };
    fixed
        .add("mutant.begin",
             [&app, mutant, report, now](ecs::World& world) {
                 const std::uint64_t step = now(world);
                 switch (mutant.kind) {
                     case Mutant::Kind::skip:
                         ecs::leave_out_system(step == mutant.step ? mutant.name : "");
                         report->made = report->made || step == mutant.step;
                         break;
                     case Mutant::Kind::drop:
                         drop_input(mutant, world, step, *report);
                         break;
                     case Mutant::Kind::watch:
                         if (step == mutant.step) {
                             watch(app, report);
                             report->made = true;
                         } else {
                             app.fixed_schedule().watch({});
                         }
                         break;
                     default:
                         break;
                 }
             })
        .after("session.begin")
        .before("gameplay.begin");
    if (of_part || mutant.kind == Mutant::Kind::crash || mutant.kind == Mutant::Kind::hang) {
        fixed
            .add("mutant.end",
                 [&app, mutant, report, now](ecs::World& world) {
                     if (now(world) == mutant.step) {
                         at_end(mutant, app, *report);
                     }
                 })
            .after("remember")
            .before("session.end");
    }
    return report;
}

}  // namespace lanthorn::tools
