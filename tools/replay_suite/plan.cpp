#include "tools/replay_suite/plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/content_hash.h"
#include "lanthorn/replay/recording.h"
#include "tools/replay_suite/files.h"
#include "tools/replay_suite/slurm_array.h"

namespace lanthorn::suite {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// A start of the program with its level, and a step; of the slowest level on an old processor.
constexpr double kStartSeconds = 0.3;
constexpr double kSecondsAStep = 0.0004;

// Files are read as they are; what is wrong with one is for verify to say.
std::string hash_or_absent(const std::string& path) {
    try {
        return path.empty() ? "none" : fmt::format("{:016x}", replay::hash_file(path));
    } catch (const Error&) {
        return "unreadable";
    }
}

std::uint64_t steps_in(const std::string& file) {
    try {
        return replay::read_recording(file).steps.size();
    } catch (const Error&) {
        return 0;
    }
}

std::string hash_text(const std::string& text) {
    return fmt::format("{:016x}", replay::hash_bytes(std::as_bytes(std::span(text))));
}

// What its marks are held against (pictures/RECORDING/*), if they are.
std::string hash_of_pictures(const fs::path& recording, const std::vector<std::string>& options) {
    const auto has = [&](const char* option) { return std::ranges::find(options, option) != options.end(); };
    const fs::path folder = recording.parent_path() / "pictures" / recording.stem();
    std::error_code error;
    if ((!has("--pictures") && !has("--light")) || !fs::is_directory(folder, error)) {
        return "none";
    }
    std::string all;
    for (const char* ending : {".png", ".json"}) {
        for (const fs::path& file : files_of(folder, ending)) {
            all += file.filename().string() + hash_or_absent(file);
        }
    }
    return hash_text(all);
}

}  // namespace

double Item::seconds() const {
    return kStartSeconds + kSecondsAStep * static_cast<double>(steps);
}

std::string Plan::key() const {
    std::string all = program;
    for (const Item& item : items) {
        all += item.key;
    }
    return hash_text(all);
}

std::string derived_key(const std::string& base, const std::vector<std::string>& options) {
    return hash_text(fmt::format("{}|{}", base, fmt::join(options, "|")));
}

Plan plan_folder(const std::string& folder, const std::string& program, const std::string& build,
                 std::vector<std::string> options, const Limits& limits, const LevelOf& level_of,
                 const std::vector<std::string>& keep) {
    Plan plan{program, build, std::move(options), limits, {}, {}};
    const std::string program_hash = hash_or_absent(program);
    for (const fs::path& file : files_of(folder, ".rec")) {
        Item item;
        item.id = file.filename().string();
        if (!keep.empty() && std::ranges::find(keep, item.id) == keep.end() &&
            std::ranges::find(keep, file.stem().string()) == keep.end()) {
            continue;
        }
        item.file = fs::absolute(file).string();
        item.level = level_of(item.file);
        item.steps = steps_in(item.file);
        item.key = hash_text(fmt::format("{}|{}|{}|{}|{}", hash_or_absent(item.file),
                                         hash_or_absent(item.level), program_hash,
                                         fmt::join(plan.options, "|"), hash_of_pictures(file, plan.options)));
        plan.items.push_back(std::move(item));
    }
    if (plan.items.empty()) {
        throw InputError(folder, "",
                         keep.empty() ? "found no recordings, expected files *.rec"
                                      : fmt::format("found no recording called {}", fmt::join(keep, " or ")));
    }
    std::ranges::stable_sort(plan.items, std::greater<>(), &Item::steps);
    return plan;
}

std::vector<Item> shuffled_items(const Plan& plan, int count) {
    std::vector<Item> items;
    for (const Item& item : plan.items) {
        for (int seed = 1; seed <= count; ++seed) {
            Item other = item;
            other.kind = ItemKind::shuffle;
            other.id = fmt::format("{}~shuffle {}", item.id, seed);
            other.options = {"--shuffle", std::to_string(seed)};
            other.key = derived_key(item.key, other.options);
            items.push_back(std::move(other));
        }
    }
    return items;
}

std::vector<std::vector<std::size_t>> slices(const Plan& plan, double seconds) {
    std::vector<double> work;
    for (const Item& item : plan.items) {
        work.push_back(item.seconds());
    }
    return cut_slices(work, seconds);
}

void write_plan(const fs::path& file, const Plan& plan) {
    json items = json::array();
    for (const Item& item : plan.items) {
        items.push_back({{"id", item.id},
                         {"kind", kItemKinds[static_cast<std::size_t>(item.kind)]},
                         {"file", item.file},
                         {"level", item.level},
                         {"options", item.options},
                         {"expect", item.expect},
                         {"steps", item.steps},
                         {"key", item.key}});
    }
    const json slices = plan.slices;
    const json text = {{"program", plan.program},
                       {"build", plan.build},
                       {"options", plan.options},
                       {"limits",
                        {{"seconds", plan.limits.seconds},
                         {"stuck_seconds", plan.limits.stuck_seconds},
                         {"memory_mib", plan.limits.memory_mib}}},
                       {"slices", slices},
                       {"items", items}};
    write_file(file, text.dump(1) + "\n");
}

Plan read_plan(const fs::path& file) {
    const json text = parse_json_object(read_whole(file), file.string(), "a plan");
    try {
        Plan plan;
        plan.program = text.at("program");
        plan.build = text.at("build");
        plan.options = text.at("options").get<std::vector<std::string>>();
        plan.slices = text.at("slices").get<std::vector<std::vector<std::size_t>>>();
        const json& limits = text.at("limits");
        plan.limits = {limits.at("seconds"), limits.at("stuck_seconds"), limits.at("memory_mib")};
        for (const json& from : text.at("items")) {
            Item item;
            item.id = from.at("id");
            const auto kind = std::ranges::find(kItemKinds, from.at("kind").get<std::string>());
            if (kind == std::end(kItemKinds)) {
                throw InputError(file.string(), item.id, "found a kind that is there is not");
            }
            item.kind = static_cast<ItemKind>(kind - std::begin(kItemKinds));
            item.file = from.at("file");
            item.level = from.at("level");
            item.options = from.at("options").get<std::vector<std::string>>();
            item.expect = from.at("expect").get<std::vector<std::string>>();
            item.steps = from.at("steps");
            item.key = from.at("key");
            plan.items.push_back(std::move(item));
        }
        return plan;
    } catch (const json::exception& error) {
        throw InputError(file.string(), "", std::string("found no plan of a suite: ") + error.what());
    }
}

}  // namespace lanthorn::suite
