// What a suite runs: every recording of a folder, each as an item with a key that names its result.
//
// A key is a hash of all that a verdict depends on: the recording, its level, the program, the options. So a
// result that is there already needs no second run, and two results of one key must be equal.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/replay_suite/limited_child.h"

namespace lanthorn::suite {

enum class ItemKind {
    replay,   // must hold
    shuffle,  // the same in another legal order of the schedule: must hold
    watch,    // the same, to learn what each system changes in a step
    mutant,   // with a fault that the suite makes: must fail, and say where
    blemish,  // with a fault in the picture of a mark: that picture must fail
};
inline constexpr const char* kItemKinds[] = {"replay", "shuffle", "watch", "mutant", "blemish"};
// Whether a fault is made in it, which is to be caught.
constexpr bool is_fault(ItemKind kind) {
    return kind == ItemKind::mutant || kind == ItemKind::blemish;
}

// One run of `lanthorn replay verify`.
struct Item {
    std::string id;  // "pool.rec", "pool.rec~shuffle 3": names it to people
    ItemKind kind = ItemKind::replay;
    std::string file;                  // absolute
    std::string level;                 // absolute; empty where none was found
    std::vector<std::string> options;  // of verify, beyond the plan's
    std::vector<std::string>
        expect;               // of a mutant: parts of which one must be named, where it cannot know itself
    std::uint64_t steps = 0;  // that the file holds; 0 where it cannot be read
    std::string key;          // 16 hexadecimal digits

    double seconds() const;  // an estimate of what it takes, by which slices are cut
};

struct Plan {
    std::string program;               // that has `replay verify`; absolute
    std::string build;                 // words for people
    std::vector<std::string> options;  // of verify, for every item
    Limits limits;                     // of every child
    std::vector<Item> items;           // longest first
    // Positions in `items`, a slice a task of a farm; empty where this machine runs all.
    std::vector<std::vector<std::size_t>> slices;

    // Changes with anything that is run. 16 hexadecimal digits.
    std::string key() const;
};

// The recordings (*.rec) of a folder, whose levels lie at `level_of(file)`. `keep`: names to take, all where
// it is empty. Throws InputError for a folder that cannot be read, has no recordings, or lacks one of `keep`.
// O(bytes of recordings and levels).
using LevelOf = std::function<std::string(const std::string& file)>;
Plan plan_folder(const std::string& folder, const std::string& program, const std::string& build,
                 std::vector<std::string> options, const Limits& limits, const LevelOf& level_of,
                 const std::vector<std::string>& keep = {});

// Every recording of `plan` in `count` other orders of the schedule, with seeds 1 to `count`.
std::vector<Item> shuffled_items(const Plan& plan, int count);

// Fills in the key of an item of that plan, whose files are `plan`'s; `base` is a key of the same files.
std::string derived_key(const std::string& base, const std::vector<std::string>& options);

// Items in slices of about `seconds` of work, none empty: positions in plan.items, longest slices first.
std::vector<std::vector<std::size_t>> slices(const Plan& plan, double seconds);

// A plan as a file, for workers on other machines. read_plan throws InputError for what is not one.
void write_plan(const std::filesystem::path& file, const Plan& plan);
Plan read_plan(const std::filesystem::path& file);

}  // namespace lanthorn::suite
