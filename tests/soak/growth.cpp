#include "tests/soak/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>

namespace lanthorn::game {

namespace {

struct Kind {
    const char* name;
    std::uint64_t shell::Holdings::*held;
    double share;  // that the least may grow by
    double more;   // and beside that
};

// Some buffers keep the size of the most that they held. Heap and resident set go up and down by as much as
// is allowed here from one visit of a level to the next, in eight rounds without a trend: a smaller leak
// takes a longer soak to be found. Some programs are made when they are first needed.
constexpr double kMB = 1e6;
constexpr std::array kKinds = {Kind{"heap", &shell::Holdings::heap, 0.1, 130 * kMB},
                               Kind{"resident", &shell::Holdings::resident, 0.1, 220 * kMB},
                               Kind{"gpu", &shell::Holdings::gpu, 0.02, 1 * kMB},
                               Kind{"textures", &shell::Holdings::textures, 0, 2},
                               Kind{"buffers", &shell::Holdings::buffers, 0, 4},
                               Kind{"framebuffers", &shell::Holdings::framebuffers, 0, 2},
                               Kind{"queries", &shell::Holdings::queries, 0, 2},
                               Kind{"programs", &shell::Holdings::programs, 0, 16},
                               Kind{"files", &shell::Holdings::files, 0, 0},
                               Kind{"threads", &shell::Holdings::threads, 0, 0}};

bool is_bytes(const Kind& kind) {
    return kind.more >= kMB;
}

std::string words(const Kind& kind, std::uint64_t count) {
    return is_bytes(kind) ? fmt::format("{:.1f} MB", static_cast<double>(count) / kMB)
                          : std::to_string(count);
}

std::uint64_t least(std::span<const shell::Holdings> of, const Kind& kind) {
    return (*std::ranges::min_element(of, {}, kind.held)).*kind.held;
}

// What was held in each state that was seen often enough.
std::map<std::string, std::vector<shell::Holdings>> by_state(const std::vector<Sample>& samples,
                                                             std::size_t fewest) {
    std::map<std::string, std::vector<shell::Holdings>> states;
    for (const Sample& sample : samples) {
        states[sample.state].push_back(sample.held);
    }
    std::erase_if(states,
                  [&](const auto& state) { return state.second.size() < std::max<std::size_t>(fewest, 4); });
    return states;
}

}  // namespace

std::size_t states_seen(const std::vector<Sample>& samples, std::size_t fewest) {
    return by_state(samples, fewest).size();
}

std::vector<std::string> growth(const std::vector<Sample>& samples, std::size_t fewest) {
    std::vector<std::string> lines;
    for (const auto& [state, all] : by_state(samples, fewest)) {
        const std::span<const shell::Holdings> settled = std::span(all).subspan(all.size() / 5);
        const auto first = settled.first(settled.size() / 2), second = settled.subspan(settled.size() / 2);
        for (const Kind& kind : kKinds) {
            const std::uint64_t before = least(first, kind), after = least(second, kind);
            if (static_cast<double>(after) > (1 + kind.share) * static_cast<double>(before) + kind.more) {
                lines.push_back(fmt::format("{}: {} {} -> {}", state, kind.name, words(kind, before),
                                            words(kind, after)));
            }
        }
    }
    return lines;
}

std::string summary(const std::vector<Sample>& samples) {
    std::vector<shell::Holdings> all;
    std::ranges::transform(samples, std::back_inserter(all), &Sample::held);
    std::string line;
    for (const Kind& kind : kKinds) {
        if (all.empty()) {
            break;
        }
        const std::uint64_t most = (*std::ranges::max_element(all, {}, kind.held)).*kind.held;
        line += fmt::format("{}{} {}..{}", line.empty() ? "" : ", ", kind.name, words(kind, least(all, kind)),
                            words(kind, most));
    }
    return line;
}

}  // namespace lanthorn::game
