#include "tools/lanthorn/render/render_stats.h"

#include <sys/resource.h>

#include <map>
#include <nlohmann/json.hpp>

#include "engine/build_info/build_info.h"
#include "engine/core/json.h"
#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/workbench/trade_point.h"
#include "tools/workbench/scene/median.h"

namespace lanthorn::tools {

namespace {

using nlohmann::ordered_json;

constexpr double kMegabyte = 1e6;

// Median and 95th percentile (nearest rank).
ordered_json spread(std::vector<double> values) {
    const Spread result = spread_of(std::move(values));
    return {{"median", result.median}, {"p95", result.p95}};
}

// With the median of the processor time that all threads took, which other load on the machine hardly alters.
ordered_json spread(std::vector<double> values, std::vector<double> cpu) {
    ordered_json result = spread(std::move(values));
    result["cpu"] = median(std::move(cpu));
    return result;
}

// By pass name, in the order of their first appearance, one value a frame (0 where the pass did not run).
ordered_json pass_times(const std::vector<FrameTiming>& frames) {
    std::vector<std::string> order;
    std::map<std::string, std::vector<double>> times, cpu;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        for (const auto& span : frames[f].passes) {
            auto [place, is_new] = times.try_emplace(span.name, frames.size(), 0.0);
            if (is_new) {
                order.push_back(span.name);
            }
            place->second[f] += span.ms;
            cpu.try_emplace(span.name, frames.size(), 0.0).first->second[f] += span.cpu_ms;
        }
    }
    ordered_json result = ordered_json::object();
    for (const std::string& name : order) {
        result[name] = spread(times[name], cpu[name]);
    }
    return result;
}

// Milliseconds on the CPU by system of the frame schedule, in its order (0 where the system was skipped).
ordered_json system_times(const std::vector<FrameTiming>& frames) {
    ordered_json result = ordered_json::object();
    const std::size_t systems = frames.empty() ? 0 : frames.front().systems.size();
    for (std::size_t i = 0; i < systems; ++i) {
        std::vector<double> ms;
        ms.reserve(frames.size());
        for (const FrameTiming& frame : frames) {
            ms.push_back(1e3 * frame.systems[i].seconds);
        }
        result[frames.front().systems[i].name] = spread(std::move(ms));
    }
    return result;
}

// What the picture's error is likely to be, and what says so; null where the technique does not know.
ordered_json error_estimate(const gi::ErrorEstimate& estimate) {
    if (!estimate.known) {
        return nullptr;
    }
    const auto figure = [](const gi::EstimatedError& error, const gi::ErrorParts& parts) {
        return ordered_json{{"value", error.value},
                            {"low", error.low},
                            {"high", error.high},
                            {"parts",
                             {{"noise", parts.noise},
                              {"blur", parts.blur},
                              {"bend", parts.bend},
                              {"contrast", parts.contrast},
                              {"unknown", parts.unknown}}}};
    };
    return {{"relrmse", figure(estimate.relrmse, estimate.relrmse_parts)},
            {"local", figure(estimate.local, estimate.local_parts)},
            {"photons", estimate.photons},
            {"texels", estimate.texels}};
}

ordered_json budget_json(const BudgetWish& wish, const BudgetOutcome& outcome) {
    ordered_json steps = ordered_json::array();
    for (const BudgetStep& step : outcome.steps) {
        steps.push_back({{"frame", step.frame},
                         {"from", step.from},
                         {"to", step.to},
                         {"name", step.name},
                         {"scale", step.scale},
                         {"why", step.why}});
    }
    return {{"ms", wish.ms},
            {"error", wish.error},
            {"processor", wish.processor},
            {"holds", outcome.holds},
            {"verdict", outcome.verdict},
            {"ladder", outcome.ladder},
            {"steps", std::move(steps)}};
}

double peak_rss_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

std::string stats_json(const RenderOutcome& outcome, const RenderJob& job, const Settings& settings,
                       const std::string& preset, double load_ms) {
    std::vector<double> frame_ms, frame_cpu;
    for (const FrameTiming& frame : outcome.frames) {
        frame_ms.push_back(frame.ms);
        frame_cpu.push_back(frame.cpu_ms);
    }
    const gi::GiStatistics& gi = outcome.gi;
    const auto& photons = gi.of<gi::PhotonStatistics>();
    const auto& emc = gi.of<gi::EmcStatistics>();
    const auto& gather = gi.of<gi::GatherStatistics>();
    ordered_json root;
    root["technique"] = outcome.technique;
    root["preset"] = preset.empty() ? ordered_json(nullptr) : ordered_json(preset);
    root["settings"] = parse_ordered_json(settings.to_json(), "own JSON");
    root["size"] = {job.size.x, job.size.y};
    root["frames"] = job.frames;
    root["warmup"] = job.warmup;
    root["load_ms"] = load_ms;
    root["ms"] = spread(frame_ms, frame_cpu);
    root["passes"] = pass_times(outcome.frames);
    root["systems"] = system_times(outcome.frames);
    root["photons"] = {{"emitted", photons.emitted}, {"stored", photons.stored}, {"lost", photons.lost}};
    const auto rgb = [](const dvec3& v) { return ordered_json{v.r, v.g, v.b}; };
    root["photons"]["flux_emitted"] = rgb(photons.flux_emitted);
    root["photons"]["flux_stored"] = ordered_json::array();
    for (const dvec3& flux : photons.flux_stored) {
        root["photons"]["flux_stored"].push_back(rgb(flux));
    }
    const auto& lists = gi.of<gi::SplatListStatistics>();
    root["photons"]["lists"] = {
        {"entries", lists.entries}, {"capacity", lists.capacity}, {"overflows", lists.overflows}};
    root["bounces"] = gi.plan.bounces;
    root["emc"] = {{"k", emc.k},
                   {"reserved", emc.reserved},
                   {"candidates", emc.candidates},
                   {"resolution", emc.resolution},
                   {"coverage", emc.coverage},
                   {"updates", emc.updates},
                   {"refinement_steps", emc.refinement_steps},
                   {"map_mb", static_cast<double>(emc.map_bytes) / kMegabyte},
                   {"kept", emc.kept},
                   {"kept_mb", static_cast<double>(emc.kept_bytes) / kMegabyte},
                   {"brought_back", emc.brought_back}};
    root["gather"] = {{"rays", gather.rays},
                      {"remembered", gather.remembered},
                      {"lit_texels", gather.lit_texels},
                      {"points", gather.points},
                      {"blind_points", gather.blind_points},
                      {"unknown_share", gather.unknown_share}};
    if (job.budget.any()) {
        root["budget"] = budget_json(job.budget, outcome.budget);
    }
    root["error_estimate"] = error_estimate(gi.of<gi::ErrorEstimate>());
    const gi::TechniqueEntry* technique = gi::find_technique(outcome.technique);
    if (technique != nullptr && technique->statistics_json != nullptr) {
        root[technique->name] = parse_ordered_json(technique->statistics_json(gi), "own JSON");
    }
    root["images"] = ordered_json::array();
    for (const ImageF& image : outcome.images) {
        root["images"].push_back(image.metadata);
    }
    root["plan"] = parse_ordered_json(gi::plan_json(gi.plan), "own JSON");
    root["memory"] = {{"gpu_mb", static_cast<double>(outcome.gpu_bytes) / kMegabyte},
                      {"rss_mb", peak_rss_bytes() / kMegabyte}};
    root["triangles"] = outcome.triangles;
    root["nan_count"] = outcome.nan_count;
    root["gl"] = {
        {"vendor", outcome.gl.vendor}, {"renderer", outcome.gl.renderer}, {"version", outcome.gl.version}};
    root["build"] = {{"version", kVersion}, {"commit", kCommit}, {"type", kBuildType}};
    return root.dump(2) + '\n';
}

std::string trace_json(const RenderOutcome& outcome) {
    ordered_json events = ordered_json::array();
    const auto add = [&](const std::string& name, double start_ms, double ms) {
        events.push_back(
            {{"name", name}, {"ph", "X"}, {"ts", 1e3 * start_ms}, {"dur", 1e3 * ms}, {"pid", 1}, {"tid", 1}});
    };
    for (std::size_t i = 0; i < outcome.frames.size(); ++i) {
        const FrameTiming& frame = outcome.frames[i];
        add("frame " + std::to_string(i), frame.start_ms, frame.ms);
        for (const auto& span : frame.passes) {
            add(span.name, frame.start_ms + span.start_ms, span.ms);
        }
    }
    return ordered_json{{"traceEvents", events}, {"displayTimeUnit", "ms"}}.dump() + '\n';
}

}  // namespace lanthorn::tools
