#include "tools/replay_suite/coverage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace lanthorn::suite {

namespace {

std::vector<Covered> covered(const std::vector<Result>& results, const char* name) {
    std::vector<Covered> list;
    std::map<std::string, std::size_t> place;
    for (const Result& result : results) {
        if (result.kind != ItemKind::replay) {
            continue;
        }
        for (const auto& [part, steps] : result.by_name(name)) {
            const auto at = place.try_emplace(part, list.size()).first->second;
            if (at == list.size()) {
                list.push_back({part, {}, 0});
            }
            list[at].steps += steps;
            if (steps > 0) {
                list[at].replays.push_back(result.id);
            }
        }
    }
    std::ranges::sort(list, {}, &Covered::name);
    return list;
}

std::vector<std::string> names(const std::vector<Covered>& list, std::size_t replays) {
    std::vector<std::string> found;
    for (const Covered& c : list) {
        if (c.replays.size() == replays) {
            found.push_back(replays == 1 ? fmt::format("{} ({})", c.name, c.replays.front()) : c.name);
        }
    }
    return found;
}

// Again and again the replay that adds most, and of equals the one of fewest steps.
std::vector<std::string> smallest(const std::vector<const Covered*>& all, const std::vector<Worth>& worth) {
    std::set<const Covered*> open;
    for (const Covered* c : all) {
        if (!c->replays.empty()) {
            open.insert(c);
        }
    }
    std::vector<std::string> subset;
    const auto has = [](const Covered* c, const std::string& replay) {
        return std::ranges::find(c->replays, replay) != c->replays.end();
    };
    while (!open.empty()) {
        const Worth* best = nullptr;
        std::size_t most = 0;
        for (const Worth& w : worth) {
            const auto adds = static_cast<std::size_t>(
                std::ranges::count_if(open, [&](const Covered* c) { return has(c, w.replay); }));
            if (adds > most || (adds == most && adds > 0 && w.steps < best->steps)) {
                best = &w;
                most = adds;
            }
        }
        subset.push_back(best->replay);
        std::erase_if(open, [&](const Covered* c) { return has(c, best->replay); });
    }
    return subset;
}

}  // namespace

std::size_t count_covered(const std::vector<Covered>& list, std::size_t least) {
    return static_cast<std::size_t>(
        std::ranges::count_if(list, [&](const Covered& c) { return c.replays.size() >= least; }));
}

Coverage coverage_of(const std::vector<Result>& results) {
    Coverage coverage;
    coverage.parts = covered(results, "parts_changed");
    coverage.systems = covered(results, "systems_ran");
    std::vector<const Covered*> all;
    for (const auto* list : {&coverage.parts, &coverage.systems}) {
        for (const Covered& c : *list) {
            all.push_back(&c);
        }
    }
    for (const Result& result : results) {
        if (result.kind != ItemKind::replay) {
            continue;
        }
        Worth worth{result.id, result.count("steps"), {}};
        for (const Covered* c : all) {
            if (c->replays.size() == 1 && c->replays.front() == result.id) {
                worth.alone.push_back(c->name);
            }
        }
        coverage.worth.push_back(std::move(worth));
    }
    coverage.subset = smallest(all, coverage.worth);
    return coverage;
}

std::vector<std::string> coverage_lines(const Coverage& coverage) {
    std::vector<std::string> lines;
    const auto say = [&](const char* what, const char* does, const std::vector<Covered>& list) {
        if (list.empty()) {
            return;
        }
        lines.push_back(fmt::format("{} of {} {} {}, {} of them in two replays or more", count_covered(list),
                                    list.size(), what, does, count_covered(list, 2)));
        if (const auto none = names(list, 0); !none.empty()) {
            lines.push_back(fmt::format("  never: {}", fmt::join(none, ", ")));
        }
        if (const auto single = names(list, 1); !single.empty()) {
            lines.push_back(fmt::format("  in one replay alone: {}", fmt::join(single, ", ")));
        }
    };
    say("parts of the state", "change", coverage.parts);
    say("systems of a step", "run", coverage.systems);
    for (const Worth& worth : coverage.worth) {
        lines.push_back(
            fmt::format("  {}: {} steps, alone exercises {}", worth.replay, worth.steps,
                        worth.alone.empty() ? "nothing" : fmt::format("{}", fmt::join(worth.alone, ", "))));
    }
    lines.push_back(fmt::format("{} of {} replays exercise all that: {}", coverage.subset.size(),
                                coverage.worth.size(), fmt::join(coverage.subset, ", ")));
    return lines;
}

}  // namespace lanthorn::suite
