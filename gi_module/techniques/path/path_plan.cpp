#include "gi_module/techniques/path/path_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "gi_module/reference/pixel_samples.h"

namespace lanthorn::gi {

namespace {

using Pass = PathPass;
using Reason = PathReason;

constexpr std::array<std::string_view, kPathPasses> kNames = {"acceleration_structure", "first_surfaces",
                                                              "paths"};

Reason reason_of(PathInput input) {
    switch (input) {
        case PathInput::geometry:
            return Reason::geometry_changed;
        case PathInput::surfaces:
            return Reason::surfaces_changed;
        case PathInput::lights:
            return Reason::light_changed;
        case PathInput::view:
            return Reason::other_view;
        case PathInput::settings:
            break;
    }
    return Reason::other_settings;
}

// Of a pass with these stamps that runs when one differs.
void set_by(PathPlan& plan, Pass pass, const PathStamps& stamps, const PathStamps::Versions& now) {
    const std::optional<PathInput> other = stamps.other(now);
    plan.set(pass, stamps.due(now),
             stamps.empty() ? Reason::none_yet
             : other        ? reason_of(*other)
                            : Reason::holds);
}

std::string_view why(Reason reason, const PathPlan& plan) {
    switch (reason) {
        case Reason::no_frame_yet:
            return "no frame yet";
        case Reason::no_indirect_light:
            return words(plan.unlit);
        case Reason::none_yet:
            return "there is none yet";
        case Reason::geometry_changed:
            return "geometry changed";
        case Reason::surfaces_changed:
            return "materials changed";
        case Reason::light_changed:
            return "light changed";
        case Reason::other_view:
            return "the picture shows something else";
        case Reason::other_settings:
            return "other settings";
        case Reason::holds:
            return "nothing that it is made from changed: it holds";
        case Reason::mean_grows:
            return "nothing changed: more samples for the same mean";
        case Reason::spp_reached:
            return "nothing changed, and the mean has path.spp samples";
        case Reason::noise_reached:
            return "nothing changed, and the mean's noise is below path.target_noise";
    }
    return {};
}

}  // namespace

reference::PathSettings path_settings(const GiSettings& settings) {
    reference::PathSettings result = settings.of<reference::PathSettings>();
    result.bounces = settings.bounces;
    result.seed = settings.seed;
    return reference::settled(result, true);
}

PathPlan make_path_plan(const FrameScene& scene, const reference::PathSettings& settings,
                        const PathStamps::Versions& now, const PathPictures& known) {
    PathPlan plan;
    plan.unlit = light_bounds(scene).unlit;
    if (plan.unlit == Unlit::nothing_reflects) {
        plan.unlit = Unlit::no;  // as of the reference: the sky's light arrives on what is black, too
    }
    if (plan.unlit != Unlit::no) {
        plan.steps.fill({false, Reason::no_indirect_light});
        return plan;
    }
    set_by(plan, Pass::acceleration_structure, known.structure, now);
    set_by(plan, Pass::first_surfaces, known.first_surfaces, now);
    set_by(plan, Pass::paths, known.paths, now);
    if (!plan.on(Pass::paths) && known.spp > settings.spp) {
        plan.set(Pass::paths, true, Reason::other_settings);
    }
    plan.begins_again = plan.on(Pass::paths);
    if (!plan.begins_again) {
        plan.from_spp = known.spp;
        const bool reached = known.spp >= settings.spp;
        const bool quiet =
            settings.target_noise > 0 && known.noise <= static_cast<double>(settings.target_noise);
        plan.set(Pass::paths, !reached && !quiet,
                 reached ? Reason::spp_reached
                 : quiet ? Reason::noise_reached
                         : Reason::mean_grows);
    }
    if (plan.on(Pass::paths)) {
        plan.frame_spp = std::min(settings.frame_spp, settings.spp - plan.from_spp);
        if (settings.target_noise > 0) {
            plan.frame_spp =
                std::min(plan.frame_spp, reference::next_noise_check(plan.from_spp) - plan.from_spp);
        }
    }
    return plan;
}

GiPlan in_words(const PathPlan& plan, const reference::PathSettings& settings) {
    const auto size = [&](Pass pass) {
        return pass != Pass::paths ? std::string()
                                   : fmt::format("samples {} to {} of {} a pixel", plan.from_spp + 1,
                                                 plan.from_spp + plan.frame_spp, settings.spp);
    };
    return steps_in_words(plan, settings.bounces, kNames, size,
                          [&](Reason reason) { return why(reason, plan); });
}

GiPlan first_path_plan(const FrameScene& scene, const GiSettings& settings) {
    const reference::PathSettings own = path_settings(settings);
    return in_words(make_path_plan(scene, own, {}, {}), own);
}

}  // namespace lanthorn::gi
