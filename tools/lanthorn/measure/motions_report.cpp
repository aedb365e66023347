#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tools/lanthorn/common/text_table.h"
#include "tools/lanthorn/measure/measure_report.h"
#include "tools/lanthorn/measure/motions_command.h"

namespace lanthorn::tools {

namespace {

using nlohmann::ordered_json;

std::string about(Motion motion) {
    switch (motion) {
        case Motion::lamp:
            return fmt::format("lamp moves {:g} cm a frame", 100 * kLampStep);
        case Motion::dim:
            return fmt::format("lamp dims {:g} % a frame", 100 * kDimStep);
        case Motion::walk:
            return fmt::format("camera walks {:g} cm a frame", 100 * kWalkStep);
        case Motion::pan:
            return fmt::format("camera turns {:g} rad a frame", kPanStep);
        case Motion::cut:
            return "first frame after a cut";
        case Motion::box:
            return fmt::format("box moves {:g} cm a frame", 100 * kBoxStep);
        case Motion::figure:
            return "figure moves";
        default:
            return "nothing moves";
    }
}

std::string plain(double value) {
    return std::isfinite(value) ? fmt::format("{:.3f}", value) : "-";
}

std::string uncertain(double value, double sigma) {
    return std::isfinite(value) ? fmt::format("{:.4f} +-{:.4f}", value, sigma) : "lost in noise";
}

std::string percentage(double value) {
    return std::isfinite(value) ? fmt::format("{:.2f} %", 100 * value) : "-";
}

// What is lost in noise is at least what it would be over the largest change that the reference may have.
std::string flicker(const MotionFigures& f) {
    return std::isfinite(f.flicker) ? plain(f.flicker)
                                    : "above " + plain(f.change / f.reference_change_below);
}

std::string milliseconds(double wall, double processor) {
    return fmt::format("{:.1f} ({:.1f})", wall, processor);
}

// The three of indirect light that take most.
std::string dearest_passes(const MotionFigures& f) {
    constexpr std::size_t kNamed = 3;
    std::vector<std::pair<std::string, FrameCost::Pass>> passes(f.gi_passes.begin(), f.gi_passes.end());
    std::ranges::stable_sort(passes, std::greater(), [](const auto& named) { return named.second.ms; });
    std::string text;
    for (std::size_t i = 0; i < std::min(kNamed, passes.size()); ++i) {
        text += fmt::format("{}{} {:.1f}", i == 0 ? "" : ", ", passes[i].first, passes[i].second.ms);
    }
    return text;
}

// A row of the table: what it says of a motion, empty where that motion has no such row.
struct Row {
    const char* name;
    std::string (*text)(const MotionFigures&);
    bool (*has)(const MotionFigures&);
};

bool always(const MotionFigures&) {
    return true;
}
bool is(const MotionFigures& f, std::initializer_list<Motion> motions) {
    return std::ranges::find(motions, f.motion) != motions.end();
}
bool relative_to_truth(const MotionFigures& f) {
    return is(f, {Motion::lamp, Motion::dim, Motion::figure});
}
bool seen_again(const MotionFigures& f) {
    return is(f, {Motion::walk, Motion::pan});
}
bool at_rest(const MotionFigures& f) {
    return f.motion == Motion::rest;
}
bool whole_picture(const MotionFigures& f) {
    return f.motion != Motion::box;
}

const Row kRows[] = {
    {"relRMSE", [](const MotionFigures& f) { return uncertain(f.error.relrmse, f.error.relrmse_sigma); },
     whole_picture},
    {"local error", [](const MotionFigures& f) { return uncertain(f.error.local, f.error.local_sigma); },
     whole_picture},
    {"local error near the box",
     [](const MotionFigures& f) { return uncertain(f.error.local, f.error.local_sigma); },
     [](const MotionFigures& f) { return f.motion == Motion::box; }},
    {"the same over that of a box at rest", [](const MotionFigures& f) { return plain(f.over_rest); },
     [](const MotionFigures& f) { return f.motion == Motion::box; }},
    {"relRMSE over that of the lamp's last frame", [](const MotionFigures& f) { return plain(f.over_rest); },
     [](const MotionFigures& f) { return f.motion == Motion::cut; }},
    {"flux", [](const MotionFigures& f) { return plain(f.error.flux); }, always},
    {"flicker over the reference's", [](const MotionFigures& f) { return flicker(f); }, relative_to_truth},
    {"flicker at points seen again, of the mean", [](const MotionFigures& f) { return percentage(f.change); },
     seen_again},
    {"the reference's own",
     [](const MotionFigures& f) {
         return std::isfinite(f.reference_change) ? percentage(f.reference_change)
                                                  : "below " + percentage(f.reference_change_below);
     },
     seen_again},
    {"relRMSE of the first frame", [](const MotionFigures& f) { return plain(f.by_frame.front()); }, at_rest},
    {"largest error over the frame before", [](const MotionFigures& f) { return plain(f.worst_rise); },
     at_rest},
    {"seconds", [](const MotionFigures& f) { return fmt::format("{:.2f}", f.seconds); }, at_rest},
    {"pixels without light", [](const MotionFigures& f) { return fmt::format("{}", f.unlit); }, always},
    {"GI ms (processor)", [](const MotionFigures& f) { return milliseconds(f.gi, f.gi_cpu); }, always},
    {"direct ms (processor)", [](const MotionFigures& f) { return milliseconds(f.direct, f.direct_cpu); },
     always},
    {"GI over direct (processor)",
     [](const MotionFigures& f) { return fmt::format("{:.2f} ({:.2f})", f.over_direct, f.over_direct_cpu); },
     always},
    {"GI's dearest passes, ms", [](const MotionFigures& f) { return dearest_passes(f); }, always},
};

void add_rows(TextTable& table, const MotionResults& results, std::size_t motion) {
    const MotionFigures& first = results.front()[motion];
    if (!first.lacking.empty()) {
        table.add({about(first.motion), first.lacking});
        return;
    }
    for (const Row& row : kRows) {
        if (row.has(first)) {
            std::vector<std::string> cells = {fmt::format("{}: {}", about(first.motion), row.name)};
            for (const auto& one : results) {
                cells.push_back(row.text(one[motion]));
            }
            table.add(std::move(cells));
        }
    }
}

ordered_json json_of(const MotionFigures& f) {
    if (!f.lacking.empty()) {
        return {{"lacking", f.lacking}};
    }
    ordered_json passes = ordered_json::object();
    for (const auto& [name, pass] : f.gi_passes) {
        passes[name] = {{"ms", pass.ms}, {"cpu_ms", pass.cpu}};
    }
    return {{"reach_m", f.reach},
            {"relrmse", json_number(f.error.relrmse)},
            {"relrmse_sigma", f.error.relrmse_sigma},
            {"local_error", json_number(f.error.local)},
            {"local_sigma", f.error.local_sigma},
            {"flux", f.error.flux},
            {"reference_mean", f.error.reference_mean},
            {"reference_noise", f.noise.relrmse},
            {"reference_local_noise", f.noise.local},
            {"over_rest", json_number(f.over_rest)},
            {"flicker", json_number(f.flicker)},
            {"change_of_mean", json_number(f.change)},
            {"reference_change_of_mean", json_number(f.reference_change)},
            {"reference_change_below", json_number(f.reference_change_below)},
            {"worst_rise", json_number(f.worst_rise)},
            {"by_frame", f.by_frame},
            {"seconds", json_number(f.seconds)},
            {"unlit", f.unlit},
            {"gi_ms", f.gi},
            {"gi_cpu_ms", f.gi_cpu},
            {"direct_ms", f.direct},
            {"direct_cpu_ms", f.direct_cpu},
            {"gi_over_direct", f.over_direct},
            {"gi_over_direct_cpu", f.over_direct_cpu},
            {"gi_passes", std::move(passes)},
            {"nan_count", f.nan_count}};
}

}  // namespace

std::string motions_table(const MotionScene& scene, const std::vector<MotionCase>& cases,
                          const MotionResults& results, const MotionJob& job, int spp) {
    ImageError noise;
    for (const MotionFigures& f : results.front()) {
        noise.relrmse = std::max(noise.relrmse, f.noise.relrmse);
        noise.local = std::max(noise.local, f.noise.local);
    }
    std::string text = fmt::format(
        "{}: {}x{}, frame {} of each motion; references of {} samples a pixel, whose noise (relRMSE {:.3f}, "
        "local {:.3f} at most) is taken off\n",
        scene.name, job.size.x, job.size.y, job.frames, spp, noise.relrmse, noise.local);
    std::vector<std::string> heading = {""};
    for (const MotionCase& one : cases) {
        heading.push_back(one.name);
    }
    TextTable table(std::move(heading));
    for (std::size_t m = 0; m < results.front().size(); ++m) {
        add_rows(table, results, m);
    }
    return text + table.text();
}

ordered_json motions_json(const MotionScene& scene, const std::vector<MotionCase>& cases,
                          const MotionResults& results) {
    ordered_json list = ordered_json::array();
    for (std::size_t c = 0; c < cases.size(); ++c) {
        ordered_json motions = ordered_json::object();
        for (const MotionFigures& f : results[c]) {
            motions[name_of(f.motion)] = json_of(f);
        }
        list.push_back({{"case", cases[c].name}, {"motions", std::move(motions)}});
    }
    return {{"scene", scene.name}, {"cases", std::move(list)}};
}

}  // namespace lanthorn::tools
