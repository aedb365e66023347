#include "tools/lanthorn/trade/trade_children.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "lanthorn/core/error.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/lanthorn/common/common_options.h"

namespace lanthorn::tools {

namespace fs = std::filesystem;

namespace {

constexpr int kReferenceSeed = 7001;  // of no point's photons or paths

}  // namespace

ChildOutcome run_own(const std::vector<std::string>& arguments) {
    std::vector<std::string> command = {own_executable()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    ChildOutcome outcome = run_child(command);
    constexpr std::string_view kName = "lanthorn: ";
    if (outcome.last_line.starts_with(kName)) {
        outcome.last_line.erase(0, kName.size());
    }
    return outcome;
}

void make_reference(const TradeFolder& folder, const TradeOptions& options, const std::string& scene,
                    TradeMotion motion, int bounces, const StopSignal& stop) {
    const fs::path stem = folder.reference(scene, motion, bounces);
    const std::string file = listed_scene(scene, {}).file;
    const std::vector<std::string> aovs =
        bounces == 0 ? std::vector<std::string>{"indirect", "final"} : std::vector<std::string>{"indirect"};
    if (std::ranges::all_of(
            aovs, [&](const std::string& aov) { return fs::exists(stem.string() + '-' + aov + ".exr"); })) {
        return;
    }
    for (const std::string& aov : aovs) {
        const std::string part = stem.string() + '-' + aov + ".part.exr";
        std::vector<std::string> command = {
            "render",
            file,
            "-o",
            part,
            "--technique",
            "path",
            "--aov",
            aov,
            "--size",
            options.size,
            "--seed",
            std::to_string(kReferenceSeed),
            "--spp",
            std::to_string(options.reference_spp),
            "--set",
            bounces == 0 ? std::string("path.unlimited=true") : fmt::format("gi.bounces={}", bounces)};
        if (aov == "indirect") {
            command.insert(command.end(), {"--set", "path.transport=diffuse"});  // said on the chart
        }
        for (const std::string& assignment : of_references(options)) {
            command.insert(command.end(), {"--set", assignment});
        }
        const std::vector<std::string> view = view_arguments(folder.shown_last(scene, motion), 0);
        command.insert(command.end(), view.begin(), view.end());
        if (options.by_others()) {
            command.insert(
                command.end(),
                {"--executor", options.farm.executor.empty() ? std::string("local") : options.farm.executor,
                 "--jobs", std::to_string(options.farm.jobs), "--slice-seconds",
                 fmt::format("{}", options.farm.slurm.slice_seconds)});
            for (const std::string& option : options.farm.slurm.sbatch) {
                command.push_back("--sbatch=" + option);
            }
        }
        const ChildOutcome outcome = run_own(command);
        if (stop.asked() || !outcome.ok()) {
            std::error_code ignored;
            fs::remove(part, ignored);
        }
        if (stop.asked()) {
            return;
        }
        if (!outcome.ok()) {
            const int code = outcome.signal != 0 ? 1 : outcome.code;
            throw Error(static_cast<ExitCode>(code),
                        fmt::format("trade: reference of {}: {}", scene, outcome.why()));
        }
        const std::string whole = stem.string() + '-' + aov + ".exr";
        std::error_code error;
        fs::rename(part, whole, error);
        if (error) {
            throw InputError(whole, "", "cannot be written: " + error.message());
        }
    }
}

std::vector<std::string> point_command(const TradePoint& point, const TradeOptions& options,
                                       const TradeReferences& references, const fs::path& stem) {
    const TradeMeasurement& job = options.job;
    std::vector<std::string> command = {"trade-point",   point.scene, "--technique",
                                        point.technique, "--preset",  point.preset};
    const std::vector<std::string> view = view_arguments(job.view, 0);
    command.insert(command.end(), view.begin(), view.end());
    const std::pair<const char*, int> numbers[] = {{"--width", job.size.x},
                                                   {"--height", job.size.y},
                                                   {"--frames", job.frames},
                                                   {"--warmup", job.warmup},
                                                   {"--thumbnail", options.thumbnail}};
    for (const auto& [name, number] : numbers) {
        command.insert(command.end(), {name, std::to_string(number)});
    }
    command.insert(command.end(), {"--motion", name_of(point.motion), "--same", references.same, "--all",
                                   references.all, "--final", references.final, "-o", stem.string()});
    for (const auto* list : {&point.common, &point.assignments}) {
        for (const std::string& assignment : *list) {
            command.insert(command.end(), {"--set", assignment});
        }
    }
    return command;
}

}  // namespace lanthorn::tools
