#include "tools/replay_suite/mutant_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "lanthorn/replay/content_hash.h"

namespace lanthorn::suite {

namespace {

using nlohmann::json;

constexpr int kDrops = 4;    // of a recording's inputs
constexpr int kWatched = 2;  // of a recording's steps

std::uint64_t random(const std::string& what) {
    return replay::hash_bytes(std::as_bytes(std::span(what)));
}

// Not at the very ends, where nothing goes before or follows.
std::uint64_t step_of(const Item& replay, std::uint64_t number) {
    return replay.steps < 4 ? replay.steps / 2 : 1 + number % (replay.steps - 2);
}

Item with_fault(const Item& replay, ItemKind kind, const std::string& fault, std::uint64_t step,
                std::uint64_t number) {
    Item item = replay;
    item.kind = kind;
    const std::string spec = fmt::format("{}@{}#{:x}", fault, step, number >> 48);
    item.id = replay.id + "~" + spec;
    item.options.insert(item.options.end(), {"--mutant", spec, "--brief"});
    item.key = derived_key(replay.key, item.options);
    return item;
}

// "flip:door@412#1a2b".
Item mutant(const Item& replay, const std::string& fault) {
    const std::uint64_t number = random(replay.id + fault);
    return with_fault(replay, ItemKind::mutant, fault, step_of(replay, number), number);
}

// Systems of a watched step, each with what it changed, that can be left out: what comes before the fault is
// made, and what records, cannot.
std::vector<Item> skips(const Item& replay, const Result& watched) {
    std::vector<Item> items;
    const json report = watched.verify.value("mutant", json::object());
    const json systems = report.value("systems", json::object());
    for (const auto& [system, parts] : systems.items()) {
        if (system == "restore" || system.starts_with("session.") || system.starts_with("mutant.")) {
            continue;
        }
        items.push_back(with_fault(replay, ItemKind::mutant, "skip:" + system,
                                   report.value("step", std::uint64_t{0}), 0));
        items.back().expect = parts.get<std::vector<std::string>>();
    }
    return items;
}

const Result* passed(const std::vector<Result>& results, const Item& replay) {
    const auto result = std::ranges::find(results, replay.key, &Result::key);
    return result == results.end() || !result->good() || replay.steps == 0 ? nullptr : &*result;
}

}  // namespace

std::vector<Item> watch_items(const std::vector<Item>& replays, const std::vector<Result>& results) {
    std::vector<Item> items;
    for (const Item& replay : replays) {
        for (int i = 0; passed(results, replay) != nullptr && i < kWatched; ++i) {
            const std::uint64_t number = random(fmt::format("{} watch {}", replay.id, i));
            items.push_back(with_fault(replay, ItemKind::watch, "watch", step_of(replay, number), 0));
        }
    }
    return items;
}

std::vector<Item> mutant_items(const std::vector<Item>& replays, const std::vector<Result>& results,
                               int most) {
    // Rows of mutants, a row a recording and kind.
    std::vector<std::vector<Item>> rows;
    for (const Item& replay : replays) {
        const Result* result = passed(results, replay);
        if (result == nullptr) {
            continue;
        }
        std::vector<Item> flips, swaps, skipped, drops;
        for (const auto& [part, steps] : result->by_name("parts_changed")) {
            if (part != "entities") {
                // Those that change first: the others may not even be there.
                const bool changes = steps > 0;
                const auto place = [changes](std::vector<Item>& row) {
                    return changes ? row.begin() : row.end();
                };
                flips.insert(place(flips), mutant(replay, "flip:" + part));
                swaps.insert(place(swaps), mutant(replay, "swap:" + part));
            }
        }
        for (const Result& watched : results) {
            if (watched.kind == ItemKind::watch && watched.id.starts_with(replay.id + "~") &&
                watched.good()) {
                std::ranges::move(skips(replay, watched), std::back_inserter(skipped));
            }
        }
        for (int i = 0; i < kDrops; ++i) {
            drops.push_back(mutant(replay, fmt::format("drop:{}", i)));
        }
        std::ranges::sort(skipped, {}, [](const Item& item) { return random(item.id); });
        for (auto* row : {&flips, &skipped, &drops, &swaps}) {
            rows.push_back(std::move(*row));
        }
    }
    std::erase_if(rows, [](const auto& row) { return row.empty(); });
    std::ranges::sort(rows, {}, [](const auto& row) { return random(row.front().id); });
    std::vector<Item> items;
    const auto wanted = static_cast<std::size_t>(most);
    for (std::size_t i = 0; items.size() < wanted; ++i) {
        const std::size_t before = items.size();
        for (std::vector<Item>& row : rows) {
            if (i < row.size() && items.size() < wanted) {
                items.push_back(std::move(row[i]));
            }
        }
        if (items.size() == before &&
            std::ranges::all_of(rows, [&](const auto& row) { return i >= row.size(); })) {
            break;
        }
    }
    return items;
}

std::vector<Item> blemish_items(const std::vector<Item>& replays, const std::vector<Result>& results,
                                int most) {
    std::vector<Item> items;
    for (std::size_t turn = 0; turn < std::size(kBlemishes); ++turn) {
        std::size_t marks = 0;
        for (const Item& replay : replays) {
            const Result* result = passed(results, replay);
            const json pictures =
                result != nullptr ? result->verify.value("pictures", json::array()) : json::array();
            for (const json& picture : pictures) {
                if (items.size() == static_cast<std::size_t>(most)) {
                    return items;
                }
                const std::string fault = kBlemishes[(turn + marks++) % std::size(kBlemishes)],
                                  mark = picture.value("mark", "");
                Item item = replay;
                item.kind = ItemKind::blemish;
                item.id = fmt::format("{}:{}~{}", replay.id, mark, fault);
                item.options.insert(item.options.end(),
                                    {"--mark", mark, "--picture-fault", fault, "--brief", "--marks-alone"});
                item.key = derived_key(replay.key, item.options);
                items.push_back(std::move(item));
            }
        }
    }
    return items;
}

}  // namespace lanthorn::suite
