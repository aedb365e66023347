// The tables that `lanthorn measure costs` prints.
#include <fmt/format.h>

#include <algorithm>

#include "tools/lanthorn/common/text_table.h"
#include "tools/lanthorn/measure/costs_report.h"

namespace lanthorn::tools {

namespace {

constexpr double kLeastPass = 0.005;  // milliseconds: a pass that takes less is not printed
constexpr std::size_t kAssets = 12;   // that are printed

std::string ms_text(double value) {
    return fmt::format("{:.2f}", value);
}

std::string mb_text(std::uint64_t bytes) {
    return fmt::format("{:.2f}", megabytes(bytes));
}

std::string passes_text(const FrameCosts& costs) {
    TextTable table({fmt::format("{}, by pass", name_of(costs.motion)), "ms", "mean", "by the clock"});
    PassCost little;
    for (const auto& [name, pass] : ordered_passes(costs)) {
        if (pass.ms < kLeastPass && pass.mean < kLeastPass) {
            little.ms += pass.ms;
            little.mean += pass.mean;
            little.clock += pass.clock;
        } else {
            table.add({(pass.gi ? "indirect: " : "") + name, ms_text(pass.ms), ms_text(pass.mean),
                       ms_text(pass.clock)});
        }
    }
    table.add({"passes that take less", ms_text(little.ms), ms_text(little.mean), ms_text(little.clock)});
    table.add({"sum of the passes", ms_text(costs.passes_ms()), ms_text(costs.passes_mean()), ""});
    for (const RestLine& line : rest_lines(costs)) {
        table.add({"rest: " + line.name, ms_text(line.ms), "", ""});
    }
    table.add({"whole frame", ms_text(costs.whole), ms_text(costs.whole_mean), ms_text(costs.whole_clock)});
    return table.text();
}

std::string lights_text(const SceneCosts& scene) {
    std::vector<std::string> heading = {"by light", "kind", "share", "lux"};
    for (const Motion motion : scene.light_motions) {
        heading.push_back(name_of(motion) + " ms");
        heading.emplace_back("+-");
        heading.emplace_back("by the clock");
    }
    TextTable table(heading);
    for (const LightCost& light : scene.lights) {
        std::vector<std::string> row = {light.name, light.kind, fmt::format("{:.1f} %", 100 * light.share),
                                        fmt::format("{:.3g}", light.lux)};
        for (const auto& cost : light.by_motion) {
            row.push_back(cost ? ms_text(cost->ms) : "not muted");
            row.push_back(cost ? ms_text(cost->noise) : "");
            row.push_back(cost ? ms_text(cost->clock) : "");
        }
        table.add(row);
    }
    return scene.lights.empty() ? "no light\n" : table.text();
}

void add_assets(TextTable& table, const std::string& kind, const std::vector<AssetBytes>& assets) {
    for (std::size_t i = 0; i < std::min(assets.size(), kAssets); ++i) {
        table.add(
            {kind + ' ' + assets[i].name, mb_text(assets[i].gpu), mb_text(assets[i].cpu), assets[i].size});
    }
    if (assets.size() > kAssets) {
        AssetBytes others;
        for (std::size_t i = kAssets; i < assets.size(); ++i) {
            others.gpu += assets[i].gpu;
            others.cpu += assets[i].cpu;
        }
        table.add({fmt::format("{} more of that kind", assets.size() - kAssets), mb_text(others.gpu),
                   mb_text(others.cpu), ""});
    }
}

std::string memory_text(const SceneMemory& memory) {
    TextTable parts({"by what keeps it", "GPU MB", "what it is"});
    for (const SceneMemory::Part& part : memory.parts) {
        parts.add({part.name, mb_text(part.gpu), part.about});
    }
    parts.add({"all of the GPU's", mb_text(memory.gpu),
               fmt::format("{} maps, {} lit texels, {} remembered rays; the process had {} MB at most",
                           memory.maps, memory.lit_texels, memory.remembered_rays, mb_text(memory.process))});
    TextTable assets({"by asset", "GPU MB", "CPU MB", "size"});
    add_assets(assets, "mesh", memory.meshes);
    add_assets(assets, "image", memory.images);
    return parts.text() + '\n' + assets.text();
}

std::string left_out_text(const MotionCosts& motion) {
    const std::string name = name_of(motion.planned.motion);
    TextTable rules({name + ", without the rule", "ms", "by the clock", "would be done", "would be more"});
    for (const RuleCost& rule : motion.rules) {
        rules.add({rule.rule.setting, fmt::format("{:+.2f}", rule.ms), fmt::format("{:+.2f}", rule.clock),
                   fmt::format("{}", fmt::join(rule.lines, ", ")),
                   fmt::format("{}", fmt::join(rule.smaller, ", "))});
    }
    TextTable lines({name + ", left out", "done in", "would cost ms", "by", "why"});
    for (const LeftOutLine& line : motion.left_out) {
        lines.add({line.pass, fmt::format("{} of {}", line.ran, motion.planned.frames),
                   line.ms ? fmt::format("{:+.2f}", *line.ms) : std::string("-"),
                   line.rules.empty() ? "no rule" : fmt::format("{}", fmt::join(line.rules, ", ")),
                   line.why});
    }
    return rules.text() + "  " + noise_words(motion) + "\n\n" + lines.text();
}

}  // namespace

std::string time_words(bool software) {
    return software ? "milliseconds are processor time of all threads"
                    : "milliseconds of passes are those of the GPU's clock";
}

std::vector<std::pair<std::string, PassCost>> ordered_passes(const FrameCosts& costs) {
    std::vector<std::pair<std::string, PassCost>> passes(costs.passes.begin(), costs.passes.end());
    std::ranges::stable_sort(passes, [](const auto& a, const auto& b) { return a.second.ms > b.second.ms; });
    return passes;
}

std::vector<RestLine> rest_lines(const FrameCosts& costs) {
    return {{"outside of passes: transforms, animation, plans, lists, waiting", costs.outside},
            {"what medians do not add up by", costs.rest() - costs.outside}};
}

std::string noise_words(const MotionCosts& costs) {
    return costs.rounds > 1 ? fmt::format("rounds differ by {:.2f} ms: less tells nothing", costs.noise)
                            : std::string("one round: how much of it is noise is not known (--rounds)");
}

std::string costs_text(const SceneCosts& scene, const CostsHead& head) {
    std::string text = fmt::format("{}: {}{}, {}x{}, {}; {}\n\n", scene.name, head.technique,
                                   head.preset.empty() ? "" : ' ' + head.preset, head.size.x, head.size.y,
                                   head.renderer, head.time);
    for (const MotionCosts& motion : scene.motions) {
        text += motion.planned.lacking.empty()
                    ? passes_text(motion.planned)
                    : fmt::format("{}: {}\n", name_of(motion.planned.motion), motion.planned.lacking);
        text += '\n';
    }
    text += lights_text(scene) + '\n' + memory_text(scene.motions.front().planned.memory) + '\n';
    for (const MotionCosts& motion : scene.motions) {
        if (motion.planned.lacking.empty()) {
            text += left_out_text(motion) + '\n';
        }
    }
    return text;
}

}  // namespace lanthorn::tools
