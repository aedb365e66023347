#include "tools/lanthorn/trade/trade_folder.h"

#include <fmt/format.h>

#include <fstream>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "engine/build_info/build_info.h"
#include "gi_module/reference/scene_hash.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/lanthorn/common/warnings.h"

namespace lanthorn::tools {

namespace fs = std::filesystem;

namespace {

std::string hex_hash(const std::string& text) {
    return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

}  // namespace

std::string processor() {
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("model name")) {
            return line.substr(line.find(':') + 2);
        }
    }
    return "unknown processor";
}

TradeFolder::TradeFolder(const TradeOptions& options) : options_(options), folder_(options.output) {
    for (const fs::path& path : {folder_ / "points", folder_ / "references"}) {
        std::error_code error;
        fs::create_directories(path, error);
        if (error) {
            throw InputError(path.string(), "", "cannot be made: " + error.message());
        }
    }
    for (const char* name :
         {"trade.csv", "trade.svg", "trade-time.svg", "trade.html", "points/probe", "references/probe"}) {
        check_writable(folder_ / name);
    }
    for (const std::string& scene : options.sweep.scenes) {
        const ListedScene listed = listed_scene(scene, options.job.view);
        ShownScene shown(tell_warnings(listed.file, load_scene(listed.file, listed.view)), listed.view);
        shown.show_at(options.job.view.time.value_or(0));
        hashes_[scene] = reference::scene_hash(shown.frame());
    }
    find_motions();
}

// A scene that lacks a motion is left out of its chart, unless none has it.
void TradeFolder::find_motions() {
    for (const TradeMotion motion : options_.sweep.motions) {
        std::vector<InputError> lacking;
        for (const std::string& scene : options_.sweep.scenes) {
            const ListedScene listed = listed_scene(scene, options_.job.view);
            LastView last = last_view(listed, motion, options_.job);
            if (last.lacking.empty()) {
                views_.emplace(std::pair(scene, motion), std::move(last.view));
            } else {
                lacking.emplace_back(listed.file, "", last.lacking);
            }
        }
        if (lacking.size() == options_.sweep.scenes.size()) {
            throw lacking.front();
        }
        for (const InputError& one : lacking) {
            fmt::print(stderr, "lanthorn: warning: {}: left out\n", one.what());
        }
    }
}

fs::path TradeFolder::stem(const TradePoint& point, const SettingsSchema& schema) const {
    const TradeMeasurement& job = options_.job;
    const std::string key = fmt::format(
        "{:x} {} {} {}x{} {} {} {} {} {} {} {} {}", hashes_.at(point.scene), point.technique,
        point.settings(schema).to_json(), job.size.x, job.size.y, job.frames, job.warmup,
        name_of(point.motion), options_.reference_spp, options_.thumbnail, kCommit, kBuildType, processor());
    return folder_ / "points" / (point.scene_name() + '-' + hex_hash(key));
}

fs::path TradeFolder::reference(const std::string& scene, TradeMotion motion, int bounces) const {
    std::string key = fmt::format("{:x} {}x{} {}", hashes_.at(scene), options_.job.size.x,
                                  options_.job.size.y, options_.reference_spp);
    const SceneView& view = shown_last(scene, motion);
    if (motion == TradeMotion::figure) {
        key += fmt::format(" {}", *view.time);
    }
    if (view.box) {
        key += ' ' + text_of(*view.box);
    }
    for (const std::string& assignment : of_references(options_)) {
        key += ' ' + assignment;
    }
    return folder_ / "references" /
           fmt::format("{}-{}-{}", listed_scene(scene, {}).name,
                       bounces == 0 ? "all" : std::to_string(bounces), hex_hash(key));
}

TradeReferences TradeFolder::references(const TradePoint& point, const SettingsSchema& schema) const {
    const std::string same =
        reference(point.scene, point.motion, point.settings(schema).get<int>("gi.bounces"));
    const std::string all = reference(point.scene, point.motion, 0);
    return {same + "-indirect.exr", all + "-indirect.exr", all + "-final.exr"};
}

}  // namespace lanthorn::tools
