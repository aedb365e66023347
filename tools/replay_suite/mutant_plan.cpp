#include "tools/replay_suite/mutant_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "lanthorn/replay/content_hash.h"

namespace lanthorn::suite {

namespace {

constexpr int kDrops = 4;  // of a recording's inputs

std::uint64_t random(const std::string& what) {
    return replay::hash_bytes(std::as_bytes(std::span(what)));
}

// "flip:door@412#1a2b": not at the very ends, where nothing goes before or follows.
Item mutant(const Item& replay, const std::string& fault) {
    Item item = replay;
    item.kind = ItemKind::mutant;
    const std::uint64_t number = random(replay.id + fault);
    const std::uint64_t step = replay.steps < 4 ? replay.steps / 2 : 1 + number % (replay.steps - 2);
    const std::string spec = fmt::format("{}@{}#{:x}", fault, step, number >> 48);
    item.id = replay.id + "~" + spec;
    item.options = replay.options;
    item.options.insert(item.options.end(), {"--mutant", spec});
    item.key = derived_key(replay.key, item.options);
    return item;
}

}  // namespace

std::vector<Item> mutant_items(const std::vector<Item>& replays, const std::vector<Result>& results, int most) {
    // Rows of mutants, a row a recording and kind.
    std::vector<std::vector<Item>> rows;
    for (const Item& replay : replays) {
        const auto result = std::ranges::find(results, replay.key, &Result::key);
        if (result == results.end() || !result->good() || replay.steps == 0) {
            continue;
        }
        std::vector<Item> flips, swaps, skips, drops;
        for (const auto& [part, steps] : result->by_name("parts_changed")) {
            if (part != "entities") {
                flips.push_back(mutant(replay, "flip:" + part));
                swaps.push_back(mutant(replay, "swap:" + part));
            }
        }
        for (const auto& [system, steps] : result->by_name("systems_ran")) {
            if (steps > 0 && !system.starts_with("session.")) {
                skips.push_back(mutant(replay, "skip:" + system));
            }
        }
        for (int i = 0; i < kDrops; ++i) {
            drops.push_back(mutant(replay, fmt::format("drop:{}", i)));
        }
        for (auto* row : {&flips, &skips, &drops, &swaps}) {
            std::ranges::sort(*row, {}, [](const Item& item) { return random(item.key); });
            rows.push_back(std::move(*row));
        }
    }
    std::vector<Item> items;
    const auto wanted = static_cast<std::size_t>(most);
    for (std::size_t i = 0; items.size() < wanted; ++i) {
        const std::size_t before = items.size();
        for (std::vector<Item>& row : rows) {
            if (i < row.size() && items.size() < wanted) {
                items.push_back(std::move(row[i]));
            }
        }
        if (items.size() == before && std::ranges::all_of(rows, [&](const auto& row) { return i >= row.size(); })) {
            break;
        }
    }
    return items;
}

}  // namespace lanthorn::suite
