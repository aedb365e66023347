#include "gi_module/techniques/coarse-path/coarse_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "gi_module/shared/plan_rules.h"
#include "gi_module/shared/plan_words.h"
#include "gi_module/techniques/coarse-path/coarse_settings.h"

namespace lanthorn::gi {

namespace {

using Pass = CoarsePass;
using Reason = CoarseReason;

constexpr std::array<std::string_view, kCoarsePasses> kNames = {
    "acceleration_structure", "points", "paths", "history", "filter", "upsampling"};

// Of a pass that runs.
std::string size(Pass pass, const CoarsePlan& plan, const GiSettings& settings) {
    const auto& c = settings.of<CoarseSettings>();
    const int spacing = 1 << static_cast<int>(c.grid);
    switch (pass) {
        case Pass::points:
            return fmt::format("one every {} x {} pixels and extra ones", spacing, spacing);
        case Pass::paths:
            return fmt::format("{} a point, {} bounces", c.samples, plan.bounces);
        case Pass::history:
            return fmt::format("{} frames", plan.kept);
        case Pass::filter:
            return fmt::format("{} levels", c.filter);
        case Pass::acceleration_structure:
        case Pass::upsampling:
            break;
    }
    return {};
}

std::string why(Reason reason, const CoarsePlan& plan) {
    switch (reason) {
        case Reason::geometry_changed:
            return "refitted where something moved, rebuilt if something came or went";
        case Reason::geometry_holds:
            return "no geometry changed: it holds";
        case Reason::points_hold:
            return "neither camera nor geometry changed: the points hold";
        case Reason::light_changed:
            return "light or geometry changed";
        case Reason::mean_grows:
            return "the mean over frames still grows";
        case Reason::picture_is_complete:
            return fmt::format("a still picture has its {} frames", plan.kept);
        case Reason::old_light_must_go:
            return "old light must go";
        case Reason::nothing_moves:
            return "light and geometry stand still";
        case Reason::paths_are_noisy:
            return "along surfaces, as far as the noise goes";
        case Reason::other_filter:
            return "another filter: over the samples at hand";
        case Reason::from_grid:
            return "from the grid; what it lacks has points of its own";
        case Reason::full_resolution:
            return "gi.coarse-path.grid is 1: full resolution";
        case Reason::no_frame_yet:
        case Reason::no_indirect_light:
        case Reason::first_frame:
        case Reason::other_view:
        case Reason::picture_holds:
            break;
    }
    return std::string(plan_words(reason, plan.unlit));
}

}  // namespace

CoarsePlan make_coarse_plan(const FrameScene& scene, const GiSettings& settings,
                            const CoarseHistory& history) {
    CoarsePlan plan;
    const LightBounds bounds = light_bounds(scene);
    plan.unlit = bounds.unlit;
    if (bounds.unlit != Unlit::no) {
        plan.steps.fill({false, Reason::no_indirect_light});
        return plan;
    }
    plan.bounces = planned_bounces(settings, bounds.carried, settings.bounces);

    const auto& c = settings.of<CoarseSettings>();
    const SceneChanges& changes = scene.changes;
    const bool first = !history.has_picture;
    const bool changed = first || !changes.nothing() || changes.assets;
    plan.still_frames = changed || !history.has_samples ? 0 : history.still_frames + 1;
    plan.kept =
        plan.still_frames > 0 ? std::max({c.history, c.still_history, settings.accumulate}) : c.history;
    const bool points = first || !history.has_samples || changes.geometry || changes.camera || changes.relief;
    const bool trace = points || changed || plan.still_frames < plan.kept;
    const bool coarse = c.grid != Spacing::one;
    plan.set(Pass::acceleration_structure, first || changes.geometry,
             first              ? Reason::first_frame
             : changes.geometry ? Reason::geometry_changed
                                : Reason::geometry_holds);
    plan.set(Pass::points, points, points ? Reason::other_view : Reason::points_hold);
    plan.set(Pass::paths, trace,
             !trace    ? Reason::picture_is_complete
             : changed ? Reason::light_changed
             : points  ? Reason::other_view
                       : Reason::mean_grows);
    plan.set(Pass::history, trace, plan.still_frames > 0 ? Reason::nothing_moves : Reason::old_light_must_go);
    const bool filter = trace || !history.filtered;
    plan.set(Pass::filter, filter,
             trace    ? Reason::paths_are_noisy
             : filter ? Reason::other_filter
                      : Reason::picture_holds);
    plan.set(Pass::upsampling, filter && coarse, coarse ? Reason::from_grid : Reason::full_resolution);
    return plan;
}

GiPlan in_words(const CoarsePlan& plan, const GiSettings& settings) {
    return steps_in_words(
        plan, plan.bounces, kNames, [&](Pass pass) { return size(pass, plan, settings); },
        [&](Reason reason) { return why(reason, plan); });
}

GiPlan first_coarse_plan(const FrameScene& scene, const GiSettings& settings) {
    return in_words(make_coarse_plan(scene, settings, {}), settings);
}

}  // namespace lanthorn::gi
