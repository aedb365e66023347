#include "tools/workbench/render/budget_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/core/error.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gi/quality_ladder.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::workbench {

namespace {

constexpr std::int64_t kAskEvery = 4;  // frames: the error of a picture changes slowly
constexpr int kAllPasses = 100'000;    // as many as gi.accumulate knows

}  // namespace

BudgetRun::BudgetRun(App& app, const Settings& settings, ivec2 size, const BudgetWish& wish, bool pixels)
    : app_(app), settings_(settings), wish_(wish) {
    control_.set({.ms = wish.ms, .error = wish.error}, gi::quality_ladder(settings, size, pixels));
    apply(0);
    for (const auto& [frame, rung] : wish_.played) {
        if (rung >= control_.ladder().rungs.size()) {
            throw InputError(
                fmt::format("--play-budget: found rung {}, expected less than {}: settings, size or "
                            "AOVs are not those of the run before",
                            rung, control_.ladder().rungs.size()));
        }
    }
}

void BudgetRun::spend_spare_time(Settings& settings) const {
    const gi::TechniqueEntry& technique = gi::technique_entry(gi::gi_settings(settings).technique);
    if (!std::ranges::any_of(technique.reads,
                             [](std::string_view name) { return name == "gi.target_error"; })) {
        return;
    }
    if (settings.is_default("gi.accumulate")) {
        settings.set("gi.accumulate", kAllPasses);
    }
    if (settings.is_default("gi.target_error")) {
        settings.set("gi.target_error", static_cast<float>(wish_.error));
    }
}

void BudgetRun::apply(std::size_t to) {
    const BudgetRung& rung = control_.ladder().rungs[to];
    Settings settings = settings_;
    for (const std::string& assignment : rung.set) {
        settings.set_from_text(assignment);
    }
    if (rung.scale < 1) {
        settings.set_from_text("render.upscale=temporal");
        settings.set("render.upscale.scale", static_cast<float>(rung.scale));
        // The grid stays as it is, in pixels.
        const double points = rung.scale * rung.scale * settings.get<int>("gi.gather.points");
        settings.set("gi.gather.points", std::max(1, static_cast<int>(points)));
    }
    spend_spare_time(settings);
    gi::apply_settings(app_, settings);
    drawn_ = to;
}

void BudgetRun::begin_frame() {
    std::size_t to = control_.at();
    if (!wish_.played.empty()) {
        to = drawn_;
        for (const auto& [frame, rung] : wish_.played) {
            to = frame == frame_ ? rung : to;
        }
    }
    if (to == drawn_) {
        return;
    }
    const BudgetRung& rung = control_.ladder().rungs[to];
    steps_.push_back({frame_, drawn_, to, rung.name, rung.scale,
                      wish_.played.empty() ? control_.decisions().back().why : "as in the run before"});
    apply(to);
}

void BudgetRun::estimate() {
    asked_ = wish_.error > 0 && frame_ % kAskEvery == kAskEvery - 1;
    if (asked_) {
        const gi::ErrorEstimate estimate = gi::technique_of(app_, ViewId::first).estimate_error();
        error_ = estimate.known ? std::optional(estimate.relrmse.value) : std::nullopt;
    }
}

void BudgetRun::end_frame(double ms, double cpu_ms, std::span<const gpu::PassTimer::Span> passes) {
    ++frame_;
    if (!wish_.played.empty()) {
        return;
    }
    const double counted = wish_.processor ? cpu_ms : ms;
    control_.frame({.ms = ms,
                    .busy_ms = counted,
                    .groups = gi::group_costs(passes, counted, wish_.processor),
                    .error = asked_ ? error_ : std::nullopt,
                    .refines = std::ranges::any_of(
                        passes, [](const auto& pass) { return pass.name == "accumulation"; })});
}

BudgetOutcome BudgetRun::outcome() const {
    BudgetOutcome outcome;
    outcome.steps = steps_;
    for (const BudgetRung& rung : control_.ladder().rungs) {
        outcome.ladder.push_back(rung.name);
    }
    const bool played = !wish_.played.empty();
    outcome.verdict = played ? "decisions of a run before" : control_.verdict();
    outcome.holds = played || control_.holds();
    return outcome;
}

}  // namespace lanthorn::workbench
