#include "tools/lanthorn/replay/traced_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/ecs/world_hash.h"

namespace lanthorn::tools {

namespace {

std::string whole_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        throw InputError(path, "", "cannot be opened");
    }
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

TracedStep trace_step(ReplayedLevel& replayed, std::uint64_t step, const std::string& after) {
    App& app = replayed.app();
    while (replayed.session().steps() < step) {
        app.step();
    }
    TracedStep trace;
    trace.parts = ecs::state_parts(app.registry());
    const auto keep = [&](const ecs::World& world) {
        trace.state = ecs::Snapshot::save(world, app.registry()).to_bytes();
    };
    app.fixed_schedule().watch([&](const std::string& system, bool commands, const ecs::World& world) {
        const std::string name = commands ? system + " (commands)" : system;
        trace.systems.push_back({name, ecs::state_hashes(app.registry(), world)});
        if (name == after) {
            keep(world);
        }
    });
    app.step();
    app.fixed_schedule().watch({});
    if (trace.state.empty()) {
        keep(app.world());
    }
    return trace;
}

std::optional<TraceDifference> first_difference(const TracedStep& found, const TracedStep& expected) {
    std::string there;                         // the last system that both have
    std::size_t alone = found.systems.size();  // the first since then that is here alone
    for (std::size_t k = 0; k < found.systems.size(); ++k) {
        const auto other = std::ranges::find(expected.systems, found.systems[k].system, &SystemState::system);
        if (other == expected.systems.end()) {
            alone = std::min(alone, k);
            continue;
        }
        std::vector<std::string> parts;
        std::size_t first = 0;
        for (std::size_t i = found.parts.size(); i-- > 0;) {
            const auto part = std::ranges::find(expected.parts, found.parts[i]);
            if (part != expected.parts.end() &&
                other->hashes[static_cast<std::size_t>(part - expected.parts.begin())] !=
                    found.systems[k].hashes[i]) {
                parts.insert(parts.begin(), found.parts[i]);
                first = i;
            }
        }
        if (parts.empty()) {
            there = found.systems[k].system;
            alone = found.systems.size();
            continue;
        }
        // One that is here alone has made it, where the part already was that way after it.
        if (alone < k && found.systems[k - 1].hashes[first] == found.systems[k].hashes[first]) {
            return TraceDifference{alone, there, std::move(parts)};
        }
        return TraceDifference{k, found.systems[k].system, std::move(parts)};
    }
    return std::nullopt;
}

void write_trace(const std::string& out, const TracedStep& trace) {
    nlohmann::ordered_json systems = nlohmann::ordered_json::array();
    for (const SystemState& one : trace.systems) {
        systems.push_back({{"system", one.system}, {"hashes", one.hashes}});
    }
    write_file(out + ".json",
               nlohmann::ordered_json{{"parts", trace.parts}, {"systems", std::move(systems)}}.dump());
    write_file(out + ".state", trace.state);
}

TracedStep read_trace(const std::string& out) {
    TracedStep trace;
    const std::string file = out + ".json";
    const nlohmann::json json = parse_json(whole_file(file), file);
    try {
        json.at("parts").get_to(trace.parts);
        for (const nlohmann::json& one : json.at("systems")) {
            SystemState& state = trace.systems.emplace_back();
            one.at("system").get_to(state.system);
            one.at("hashes").get_to(state.hashes);
            if (state.hashes.size() != trace.parts.size()) {
                throw InputError(file, state.system, "found another number of hashes than of parts");
            }
        }
    } catch (const nlohmann::json::exception&) {
        throw InputError(file, "", "is no trace of a step, expected one of lanthorn replay state");
    }
    trace.state = whole_file(out + ".state");
    return trace;
}

}  // namespace lanthorn::tools
