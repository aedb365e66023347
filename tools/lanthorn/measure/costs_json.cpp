// costs.json.
#include "tools/lanthorn/measure/costs_report.h"

namespace lanthorn::tools {

namespace {

using nlohmann::ordered_json;

ordered_json plan_of(const MotionCosts& motion) {
    ordered_json rules = ordered_json::array(), lines = ordered_json::array();
    for (const RuleCost& rule : motion.rules) {
        rules.push_back({{"setting", rule.rule.setting},
                         {"leaves_out", rule.rule.leaves_out},
                         {"ms", rule.ms},
                         {"clock_ms", rule.clock},
                         {"lines", rule.lines},
                         {"smaller", rule.smaller}});
    }
    for (const LeftOutLine& line : motion.left_out) {
        lines.push_back({{"pass", line.pass},
                         {"ran", line.ran},
                         {"why", line.why},
                         {"rules", line.rules},
                         {"ms", line.ms ? ordered_json(*line.ms) : ordered_json(nullptr)}});
    }
    return {{"rules", std::move(rules)}, {"lines", std::move(lines)}};
}

ordered_json json_of(const MotionCosts& motion) {
    const FrameCosts& costs = motion.planned;
    if (!costs.lacking.empty()) {
        return {{"motion", name_of(costs.motion)}, {"lacking", costs.lacking}};
    }
    ordered_json passes = ordered_json::array();
    for (const auto& [name, pass] : ordered_passes(costs)) {
        passes.push_back({{"pass", name},
                          {"indirect", pass.gi},
                          {"ms", pass.ms},
                          {"mean", pass.mean},
                          {"clock_ms", pass.clock}});
    }
    ordered_json rest = ordered_json::array();
    for (const RestLine& line : rest_lines(costs)) {
        rest.push_back({{"name", line.name}, {"ms", line.ms}});
    }
    return {{"motion", name_of(costs.motion)},
            {"frames", costs.frames},
            {"whole", {{"ms", costs.whole}, {"mean", costs.whole_mean}, {"clock_ms", costs.whole_clock}}},
            {"noise_ms", motion.noise},
            {"passes", std::move(passes)},
            {"passes_ms", costs.passes_ms()},
            {"rest_ms", costs.rest()},
            {"rest", std::move(rest)},
            {"gpu_mb", megabytes(costs.memory.gpu)},
            {"nan_count", costs.nan_count},
            {"left_out", plan_of(motion)}};
}

ordered_json lights_of(const SceneCosts& scene) {
    ordered_json lights = ordered_json::array();
    for (const LightCost& light : scene.lights) {
        ordered_json motions = ordered_json::object();
        for (std::size_t m = 0; m < light.by_motion.size(); ++m) {
            const auto& cost = light.by_motion[m];
            motions[name_of(scene.light_motions[m])] =
                cost ? ordered_json{{"ms", cost->ms}, {"noise", cost->noise}, {"clock_ms", cost->clock}}
                     : ordered_json(nullptr);
        }
        lights.push_back({{"light", light.name},
                          {"kind", light.kind},
                          {"share", light.share},
                          {"lux", light.lux},
                          {"motions", std::move(motions)}});
    }
    return lights;
}

ordered_json assets_of(const std::vector<AssetBytes>& assets) {
    ordered_json list = ordered_json::array();
    for (const AssetBytes& asset : assets) {
        list.push_back({{"name", asset.name},
                        {"size", asset.size},
                        {"gpu_mb", megabytes(asset.gpu)},
                        {"cpu_mb", megabytes(asset.cpu)}});
    }
    return list;
}

ordered_json memory_of(const SceneMemory& memory) {
    ordered_json parts = ordered_json::array();
    for (const SceneMemory::Part& part : memory.parts) {
        parts.push_back({{"name", part.name}, {"about", part.about}, {"gpu_mb", megabytes(part.gpu)}});
    }
    return {{"gpu_mb", megabytes(memory.gpu)},
            {"rss_mb", megabytes(memory.process)},
            {"maps", memory.maps},
            {"lit_texels", memory.lit_texels},
            {"remembered_rays", memory.remembered_rays},
            {"parts", std::move(parts)},
            {"meshes", assets_of(memory.meshes)},
            {"images", assets_of(memory.images)}};
}

}  // namespace

ordered_json costs_json(const std::vector<SceneCosts>& scenes, const CostsHead& head) {
    ordered_json list = ordered_json::array();
    for (const SceneCosts& scene : scenes) {
        ordered_json motions = ordered_json::array();
        for (const MotionCosts& motion : scene.motions) {
            motions.push_back(json_of(motion));
        }
        list.push_back({{"scene", scene.name},
                        {"motions", std::move(motions)},
                        {"lights", lights_of(scene)},
                        {"memory", memory_of(scene.motions.front().planned.memory)}});
    }
    return {{"measure", "costs"},
            {"size", {head.size.x, head.size.y}},
            {"warmup", head.warmup},
            {"frames", head.frames},
            {"rounds", head.rounds},
            {"technique", head.technique},
            {"preset", head.preset.empty() ? ordered_json(nullptr) : ordered_json(head.preset)},
            {"set", head.set},
            {"renderer", head.renderer},
            {"time", head.time},
            {"build", head.build},
            {"scenes", std::move(list)}};
}

}  // namespace lanthorn::tools
