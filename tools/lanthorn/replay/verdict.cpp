#include "tools/lanthorn/replay/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace lanthorn::tools {

namespace {

constexpr std::array kWords = {"ok", "failed", "none"};

const char* word_of(Check::Verdict verdict) {
    return kWords.at(static_cast<std::size_t>(verdict));
}

std::string name_of(const Verdict& verdict) {
    return std::filesystem::path(verdict.file).filename().string();
}

nlohmann::ordered_json timeline_json(const Verdict& v) {
    nlohmann::ordered_json unequal = nlohmann::ordered_json::array(), marks = unequal;
    for (const replay::Divergence& d : v.comparison.divergences) {
        unequal.push_back({d.step, d.last});
    }
    for (const replay::Mark& mark : v.marks) {
        marks.push_back({mark.step, mark.name});
    }
    return {{"bin_steps", v.timeline.bin_steps},
            {"inputs", v.timeline.inputs},
            {"parts", v.timeline.parts},
            {"unequal", std::move(unequal)},
            {"marks", std::move(marks)}};
}

nlohmann::ordered_json pictures_json(const std::vector<PictureVerdict>& pictures) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const PictureVerdict& p : pictures) {
        nlohmann::ordered_json one{
            {"mark", p.mark}, {"step", p.step},     {"failed", p.failed},     {"text", p.text},
            {"flip", p.flip}, {"actual", p.actual}, {"expected", p.expected}, {"difference", p.difference}};
        if (!p.light.empty()) {
            one["light_failed"] = p.light_failed;
            one["light"] = p.light;
        }
        if (!p.fault.empty()) {
            one["fault"] = p.fault;
        }
        list.push_back(std::move(one));
    }
    return list;
}

}  // namespace

PictureVerdict picture_of(const nlohmann::json& json) {
    PictureVerdict p;
    p.mark = json.at("mark");
    p.step = json.at("step");
    p.failed = json.at("failed");
    p.text = json.at("text");
    p.fault = json.value("fault", "");
    p.flip = json.at("flip");
    p.light_failed = json.value("light_failed", false);
    p.light = json.value("light", "");
    p.actual = json.at("actual");
    p.expected = json.at("expected");
    p.difference = json.at("difference");
    return p;
}

bool Verdict::failed() const {
    return std::ranges::any_of(checks, [](const Check& c) { return c.verdict == Check::Verdict::failed; });
}

Timeline timeline_of(const replay::Recording& recording) {
    Timeline timeline;
    const std::uint64_t steps = recording.steps.size();
    timeline.bin_steps =
        std::max(timeline.bin_steps, (steps + Timeline::kMostBins - 1) / Timeline::kMostBins);
    for (std::uint64_t first = 0; first < steps; first += timeline.bin_steps) {
        std::uint32_t inputs = 0;
        std::vector<bool> changed(recording.header.parts.size(), false);
        for (std::uint64_t i = first; i < std::min(first + timeline.bin_steps, steps); ++i) {
            inputs += i > 0 && recording.steps[i].input != recording.steps[i - 1].input ? 1 : 0;
            for (const replay::ChangedPart& part : recording.steps[i].changed) {
                changed[part.part] = changed[part.part] || i > 0;
            }
        }
        timeline.inputs.push_back(inputs);
        timeline.parts.push_back(static_cast<std::uint32_t>(std::ranges::count(changed, true)));
    }
    return timeline;
}

std::string verdict_text(const Verdict& v) {
    if (!v.error.empty()) {
        return "";
    }
    std::string text = fmt::format("{}: {} steps ({:.1f} s), level {}, by {}\n", name_of(v), v.steps,
                                   v.seconds(), v.header.level, v.header.build);
    if (!v.cut_off.empty()) {
        text += fmt::format("  {:<13}{:<6}{}\n", "whole", "no", v.cut_off);
    }
    std::size_t judged = 0, failed = 0;
    for (const Check& check : v.checks) {
        text += fmt::format("  {:<13}{:<6}{}\n", check.name,
                            check.verdict == Check::Verdict::failed ? "FAIL" : word_of(check.verdict),
                            check.text);
        judged += check.verdict != Check::Verdict::none ? 1 : 0;
        failed += check.verdict == Check::Verdict::failed ? 1 : 0;
    }
    if (failed == 0) {
        return text + fmt::format("{}: ok\n", name_of(v));
    }
    const std::string next =
        v.comparison.divergences.empty() ? "" : "  Next: lanthorn replay bisect " + v.file;
    return text + fmt::format("{}: {} of {} checks failed.{}\n", name_of(v), failed, judged, next);
}

nlohmann::ordered_json verdict_json(const Verdict& v) {
    const replay::Comparison& c = v.comparison;
    nlohmann::ordered_json json{{"file", name_of(v)}, {"key", v.key}};
    if (!v.error.empty()) {
        json["verdict"] = "bad_input";
        json["error"] = v.error;
        return json;
    }
    json["verdict"] = v.failed() ? "failed" : "ok";
    json["level"] = v.header.level;
    json["build"] = v.build;
    json["recorded_by"] = v.header.build;
    json["steps"] = v.steps;
    json["cut_off"] = v.cut_off;
    json["seconds"] = v.seconds();
    json["simulated_steps_per_second"] = v.speed;
    json["cpu_s"] = v.cpu_seconds;
    json["hashes_compared"] = c.hashes;
    json["parts"] = c.parts;
    json["parts_changed"] = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < c.parts.size(); ++i) {
        json["parts_changed"][c.parts[i]] = c.changed[i];
    }
    json["parts_not_compared"] = c.not_compared;
    json["checks"] = nlohmann::ordered_json::array();
    for (const Check& check : v.checks) {
        json["checks"].push_back(
            {{"name", check.name}, {"verdict", word_of(check.verdict)}, {"text", check.text}});
    }
    json["divergences"] = nlohmann::ordered_json::array();
    for (const replay::Divergence& d : c.divergences) {
        json["divergences"].push_back({{"step", d.step},
                                       {"seconds", static_cast<double>(d.step) / v.header.step_rate},
                                       {"last_step", d.last},
                                       {"parts", d.parts}});
    }
    json["systems_ran"] = nlohmann::ordered_json::object();
    for (const auto& [system, steps] : v.systems_ran) {
        json["systems_ran"][system] = steps;
    }
    if (!v.pictures.empty()) {
        json["pictures_compared"] = v.pictures.size();
        json["pictures"] = pictures_json(v.pictures);
    }
    json["timeline"] = timeline_json(v);
    if (v.mutant) {
        json["mutant"] = report_json(*v.mutant);
    }
    return json;
}

}  // namespace lanthorn::tools
