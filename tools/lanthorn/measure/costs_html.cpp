// costs.html: bars, and the figures beside them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "lanthorn/core/printable.h"
#include "tools/lanthorn/measure/costs_report.h"

namespace lanthorn::tools {

namespace {

constexpr const char* kPageHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"/><title>What it costs</title>
<style>
body{font:14px/1.45 sans-serif;color:#222;margin:24px auto;max-width:1080px;padding:0 16px}
h1{font-size:22px}h2{font-size:19px;margin-top:36px;border-top:2px solid #ccc;padding-top:14px}h3{font-size:15px;margin:22px 0 4px}
table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:13px;width:100%}
th,td{padding:2px 9px;text-align:right;border-bottom:1px solid #eee;vertical-align:top}
th{background:#f4f4f4}td.text,th.text{text-align:left}td.bar{width:38%;text-align:left}
.b{display:inline-block;height:12px;vertical-align:-1px}
.gi{background:#d98a2b}.other{background:#4b7bb5}.rest{background:#b5b5b5}.less{background:#5a9e6f}
tr.sum td{font-weight:bold;border-top:1px solid #999}.note{color:#666;font-size:13px;margin:4px 0}
</style></head><body>
<h1>What it costs</h1>
)";

std::string bar_cell(double value, double most, const char* style) {
    const double share = most > 0 ? std::clamp(std::abs(value) / most, 0.0, 1.0) : 0;
    return fmt::format("<td class=\"bar\"><span class=\"b {}\" style=\"width:{:.1f}%\"></span></td>", style,
                       100 * share);
}

std::string number_cell(double value) {
    return fmt::format("<td>{:.2f}</td>", value);
}

std::string text_cell(const std::string& words) {
    return "<td class=\"text\">" + markup_text(printable(words)) + "</td>";
}

// `words`: columns of text among them, which begin where their heading does, as the first one.
std::string heading_row(const std::vector<std::string>& cells, const std::set<std::size_t>& words = {}) {
    std::string html = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
        html +=
            (i == 0 || words.contains(i) ? "<th class=\"text\">" : "<th>") + markup_text(cells[i]) + "</th>";
    }
    return html + "</tr>\n";
}

std::string passes_html(const MotionCosts& motion) {
    const FrameCosts& costs = motion.planned;
    std::string html = fmt::format("<h3>Milliseconds by pass: {}</h3>\n", name_of(costs.motion));
    if (!costs.lacking.empty()) {
        return html + "<p>" + markup_text(costs.lacking) + "</p>\n";
    }
    html += "<table>" + heading_row({"pass", "ms", "mean", "by the clock", ""});
    const double most = costs.whole;
    for (const auto& [name, pass] : ordered_passes(costs)) {
        html += "<tr>" + text_cell(name) + number_cell(pass.ms) + number_cell(pass.mean) +
                number_cell(pass.clock) + bar_cell(pass.ms, most, pass.gi ? "gi" : "other") + "</tr>\n";
    }
    html += "<tr class=\"sum\">" + text_cell("sum of the passes") + number_cell(costs.passes_ms()) +
            number_cell(costs.passes_mean()) + "<td></td>" + bar_cell(costs.passes_ms(), most, "other") +
            "</tr>\n";
    for (const RestLine& line : rest_lines(costs)) {
        html += "<tr>" + text_cell("rest: " + line.name) + number_cell(line.ms) + "<td></td><td></td>" +
                bar_cell(line.ms, most, "rest") + "</tr>\n";
    }
    html += "<tr class=\"sum\">" + text_cell("whole frame") + number_cell(costs.whole) +
            number_cell(costs.whole_mean) + number_cell(costs.whole_clock) +
            bar_cell(costs.whole, most, "rest") + "</tr></table>\n";
    return html + fmt::format("<p class=\"note\">Medians of {} frames; orange is indirect light; {}.</p>\n",
                              costs.frames, noise_words(motion));
}

std::string lights_html(const SceneCosts& scene) {
    std::string html = "<h3>By light</h3>\n";
    if (scene.lights.empty()) {
        return html + "<p>no light</p>\n";
    }
    std::vector<std::string> head = {"light", "kind", "share of the light", "lux"};
    double most = 0;
    for (const Motion motion : scene.light_motions) {
        head.push_back(name_of(motion) + ", ms");
    }
    head.emplace_back("");
    for (const LightCost& light : scene.lights) {
        for (const auto& cost : light.by_motion) {
            most = std::max(most, cost ? std::abs(cost->ms) : 0.0);
        }
    }
    html += "<table>" + heading_row(head, {1});
    for (const LightCost& light : scene.lights) {
        html += "<tr>" + text_cell(light.name) + text_cell(light.kind) +
                fmt::format("<td>{:.1f} %</td><td>{:.3g}</td>", 100 * light.share, light.lux);
        for (const auto& cost : light.by_motion) {
            html += cost ? fmt::format("<td>{:.2f} +- {:.2f}</td>", cost->ms, cost->noise)
                         : std::string("<td>not muted</td>");
        }
        const auto& last = light.by_motion.back();
        html += bar_cell(last ? last->ms : 0, most, last && last->ms < 0 ? "less" : "other") + "</tr>\n";
    }
    return html +
           "</table>\n<p class=\"note\">How much longer a frame is for the light's being there: frames "
           "with all lights, and without each in turn. The bar is of the last column of milliseconds; "
           "green: a frame is longer without it.</p>\n";
}

std::string assets_html(const std::string& title, const std::vector<AssetBytes>& assets, double most) {
    if (assets.empty()) {
        return {};
    }
    std::string html = "<table>" + heading_row({title, "size", "GPU MB", "CPU MB", ""}, {1});
    for (const AssetBytes& asset : assets) {
        html += "<tr>" + text_cell(asset.name) + text_cell(asset.size) + number_cell(megabytes(asset.gpu)) +
                number_cell(megabytes(asset.cpu)) + bar_cell(megabytes(asset.gpu), most, "other") + "</tr>\n";
    }
    return html + "</table>\n";
}

std::string memory_html(const SceneMemory& memory) {
    const double most = megabytes(memory.gpu);
    std::string html =
        "<h3>Megabytes</h3>\n<table>" + heading_row({"kept by", "what it is", "GPU MB", ""}, {1});
    for (const SceneMemory::Part& part : memory.parts) {
        html += "<tr>" + text_cell(part.name) + text_cell(part.about) + number_cell(megabytes(part.gpu)) +
                bar_cell(megabytes(part.gpu), most, &part == &memory.parts.back() ? "rest" : "other") +
                "</tr>\n";
    }
    html += "<tr class=\"sum\">" + text_cell("all of the GPU's") + text_cell("") + number_cell(most) +
            bar_cell(most, most, "rest") + "</tr></table>\n";
    html += fmt::format(
        "<p class=\"note\">{} environment maps, {} lit texels, {} remembered rays. The process "
        "had {:.1f} MB at most.</p>\n",
        memory.maps, memory.lit_texels, memory.remembered_rays, megabytes(memory.process));
    double largest = 0;
    for (const auto* assets : {&memory.meshes, &memory.images}) {
        for (const AssetBytes& asset : *assets) {
            largest = std::max(largest, megabytes(asset.gpu));
        }
    }
    return html + assets_html("mesh", memory.meshes, largest) + assets_html("image", memory.images, largest);
}

std::string left_out_html(const MotionCosts& motion) {
    std::string html = fmt::format(
        "<h3>What the plan left out: {}</h3>\n<table>{}", name_of(motion.planned.motion),
        heading_row(
            {"rule", "leaves out", "would cost, ms", "by the clock", "would be done", "would be more", ""},
            {1, 4, 5}));
    double most = 0;
    for (const RuleCost& rule : motion.rules) {
        most = std::max(most, std::abs(rule.ms));
    }
    for (const RuleCost& rule : motion.rules) {
        html += "<tr>" + text_cell(rule.rule.setting) + text_cell(rule.rule.leaves_out) +
                number_cell(rule.ms) + number_cell(rule.clock) +
                text_cell(fmt::format("{}", fmt::join(rule.lines, ", "))) +
                text_cell(fmt::format("{}", fmt::join(rule.smaller, ", "))) +
                bar_cell(rule.ms, most, rule.ms < 0 ? "less" : "other") + "</tr>\n";
    }
    html += "</table>\n<table>" +
            heading_row({"line of the plan", "done in", "would cost, ms", "left out by", "why"}, {3, 4});
    for (const LeftOutLine& line : motion.left_out) {
        html += "<tr>" + text_cell(line.pass) +
                fmt::format("<td>{} of {}</td>", line.ran, motion.planned.frames) +
                (line.ms ? number_cell(*line.ms) : std::string("<td>-</td>")) +
                text_cell(line.rules.empty() ? "no rule" : fmt::format("{}", fmt::join(line.rules, ", "))) +
                text_cell(line.why) + "</tr>\n";
    }
    return html + fmt::format("</table>\n<p class=\"note\">Each rule off by itself, all others on; {}.</p>\n",
                              noise_words(motion));
}

}  // namespace

std::string costs_html(const std::vector<SceneCosts>& scenes, const CostsHead& head) {
    std::string html = kPageHead;
    html +=
        fmt::format("<p>{}{}{}, {} x {} pixels, {} frames after {}, {} rounds.<br/>{}; {}<br/>{}</p>\n",
                    markup_text(head.technique), head.preset.empty() ? "" : markup_text(' ' + head.preset),
                    head.set.empty() ? "" : ", " + markup_text(fmt::format("{}", fmt::join(head.set, " "))),
                    head.size.x, head.size.y, head.frames, head.warmup, head.rounds,
                    markup_text(head.renderer), markup_text(head.time), markup_text(head.build));
    for (const SceneCosts& scene : scenes) {
        html += "<h2>" + markup_text(printable(scene.name)) + "</h2>\n";
        for (const MotionCosts& motion : scene.motions) {
            html += passes_html(motion);
        }
        html += lights_html(scene) + memory_html(scene.motions.front().planned.memory);
        for (const MotionCosts& motion : scene.motions) {
            html += motion.planned.lacking.empty() ? left_out_html(motion) : std::string();
        }
    }
    return html + "</body></html>\n";
}

}  // namespace lanthorn::tools
