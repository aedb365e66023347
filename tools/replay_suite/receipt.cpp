#include "tools/replay_suite/receipt.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "engine/core/json.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "tools/replay_suite/files.h"

namespace lanthorn::suite {

using nlohmann::json;

bool Asked::of(const Count& count) const {
    return (mutants || (count.member != &Receipt::mutants && count.member != &Receipt::blemishes)) &&
           (pictures || (count.member != &Receipt::pictures && count.member != &Receipt::blemishes));
}

Receipt receipt_of(const std::vector<Result>& results) {
    Receipt receipt;
    std::set<std::string> parts, systems;
    for (const Result& result : results) {
        if (is_fault(result.kind)) {
            (result.kind == ItemKind::mutant ? receipt.mutants : receipt.blemishes) +=
                result.good() && result.made() ? 1 : 0;
            continue;
        }
        if (result.kind == ItemKind::watch) {
            continue;
        }
        receipt.steps += result.count("steps");
        receipt.hashes += result.count("hashes_compared");
        receipt.pictures += result.count("pictures_compared");
        if (result.kind != ItemKind::replay) {
            continue;
        }
        receipt.replays += result.verdict != Verdict::not_judged ? 1 : 0;
        for (const auto& [part, steps] : result.by_name("parts_changed")) {
            if (steps > 0) {
                parts.insert(part);
            }
        }
        for (const auto& [system, steps] : result.by_name("systems_ran")) {
            if (steps > 0) {
                systems.insert(system);
            }
        }
    }
    receipt.parts = parts.size();
    receipt.systems = systems.size();
    return receipt;
}

Ratchet read_ratchet(const std::filesystem::path& folder) {
    const auto file = folder / kRatchetFile;
    const std::string text = read_if_there(file);
    if (text.empty()) {
        return {};
    }
    const json from = parse_json_object(text, file.string(), "a ratchet");
    Ratchet ratchet;
    ratchet.there = true;
    for (const Count& count : kCounts) {
        if (!from.contains(count.name) && count.member == &Receipt::blemishes) {
            continue;  // of a version that made none
        }
        if (!from.contains(count.name) || !from[count.name].is_number_unsigned()) {
            throw InputError(file.string(), count.name, "expected a count");
        }
        ratchet.least.*count.member = from[count.name].get<std::uint64_t>();
    }
    ratchet.reason = from.value("reason", "");
    return ratchet;
}

std::vector<std::string> slips(const Receipt& now, const Ratchet& ratchet, const Asked& asked) {
    if (!ratchet.there) {
        return {fmt::format("there is no {}: --update-ratchet writes it", kRatchetFile)};
    }
    std::vector<std::string> lines;
    for (const Count& count : kCounts) {
        const std::uint64_t is = now.*count.member, was = ratchet.least.*count.member;
        if (is < was && asked.of(count)) {
            lines.push_back(fmt::format("{} {}, last time {}", is, count.name, was));
        }
    }
    return lines;
}

void write_ratchet(const std::filesystem::path& folder, const Receipt& now, const Asked& asked,
                   const std::string& reason) {
    const Ratchet before = read_ratchet(folder);
    const std::vector<std::string> fewer =
        before.there ? slips(now, before, asked) : std::vector<std::string>();
    if (!fewer.empty() && reason.find_first_not_of(" \t") == std::string::npos) {
        throw InputError(
            (folder / kRatchetFile).string(), "",
            fmt::format("found fewer than before, expected --reason: {}", fmt::join(fewer, "; ")));
    }
    json to;
    for (const Count& count : kCounts) {
        to[count.name] = (asked.of(count) ? now : before.least).*count.member;
    }
    to["reason"] = fewer.empty() ? before.reason : reason;
    write_file(folder / kRatchetFile, to.dump(2) + "\n");
}

}  // namespace lanthorn::suite
