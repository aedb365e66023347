#include "gi_module/techniques/splat/splat_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "gi_module/shared/mirrors/mirror_plan.h"
#include "gi_module/shared/plan_rules.h"
#include "gi_module/shared/plan_words.h"
#include "gi_module/techniques/splat/splat_settings.h"

namespace lanthorn::gi {

namespace {

using Pass = SplatPass;
using Reason = SplatReason;

constexpr std::array<std::string_view, kSplatPasses> kNames = {"surfaces", "photons",     "item_buffer",
                                                               "splats",   "mirror_rays", "mirrors"};

// Of a pass that runs.
std::string size(Pass pass, const SplatPlan& plan, const GiSettings& settings) {
    switch (pass) {
        case Pass::photons:
            return fmt::format("{} walks, {} bounces", plan.grow, plan.bounces);
        case Pass::mirror_rays:
            return "a ray a pixel that mirrors or is looked through";
        case Pass::splats:
        case Pass::mirrors:
            return fmt::format("of {} walks, C = {}", plan.walks, settings.of<SplatSettings>().bandwidth);
        case Pass::surfaces:
        case Pass::item_buffer:
            break;
    }
    return {};
}

std::string why(Reason reason, const SplatPlan& plan) {
    switch (reason) {
        case Reason::geometry_changed:
            return "something moved, came or went";
        case Reason::geometry_holds:
            return "no geometry changed: they hold";
        case Reason::light_changed:
            return "light or geometry changed: all anew";
        case Reason::settings_changed:
            return "other settings: all anew";
        case Reason::picture_grows:
            return "nothing changed: more, for a better picture";
        case Reason::picture_is_complete:
            return fmt::format("a still picture has its {} walks", plan.walks);
        case Reason::disk_is_full:
            return "the disk takes no more photons: those that are there are kept";
        case Reason::view_holds:
            return "neither camera nor geometry changed: it holds";
        case Reason::twice_as_many:
            return "there are twice as many photons, or there will be no more";
        case Reason::mirrors_are_off:
        case Reason::nothing_mirrors:
        case Reason::mirrors_show_more:
        case Reason::mirrors_hold:
            return std::string(mirror_words(reason));
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

SplatPlan make_splat_plan(const FrameScene& scene, const GiSettings& settings, const SplatHistory& history) {
    SplatPlan plan;
    const LightBounds bounds = light_bounds(scene);
    plan.unlit = bounds.unlit;
    if (bounds.unlit != Unlit::no) {
        plan.steps.fill({false, Reason::no_indirect_light});
        return plan;
    }
    plan.bounces = planned_bounces(settings, bounds.carried, settings.bounces);

    const auto& own = settings.of<SplatSettings>();
    const SceneChanges& changes = scene.changes;
    const bool first = !history.has_view && !history.has_photons;
    const bool changed = !changes.nothing() || changes.assets;
    plan.anew = changed || !history.has_photons;
    const auto at_once = static_cast<std::uint64_t>(std::max(settings.photons, 0));
    const std::uint64_t all = std::max(at_once, static_cast<std::uint64_t>(own.photons));
    if (plan.anew) {
        plan.grow =
            at_once > 0 ? at_once : std::min<std::uint64_t>(all, static_cast<std::uint64_t>(own.batch));
    } else if (!history.full && history.walks < all) {
        plan.grow = std::min({static_cast<std::uint64_t>(own.batch),
                              std::max<std::uint64_t>(history.walks, 1), all - history.walks});
    }
    plan.walks = (plan.anew ? 0 : history.walks) + plan.grow;
    plan.set(Pass::surfaces, first || changes.geometry || changes.assets,
             first || !(changes.geometry || changes.assets)
                 ? (first ? Reason::first_frame : Reason::geometry_holds)
                 : Reason::geometry_changed);
    plan.set(Pass::photons, plan.grow > 0,
             first           ? Reason::first_frame
             : changed       ? Reason::light_changed
             : plan.anew     ? Reason::settings_changed
             : plan.grow > 0 ? Reason::picture_grows
             : history.full  ? Reason::disk_is_full
                             : Reason::picture_is_complete);
    const bool view =
        !history.has_view || changes.geometry || changes.camera || changes.assets || changes.relief;
    plan.set(Pass::item_buffer, view, view ? Reason::other_view : Reason::view_holds);
    const bool more = plan.walks > history.splatted &&
                      (plan.walks >= 2 * history.splatted || plan.walks == all || history.full);
    const bool splat = view || plan.anew || !history.has_picture || more;
    plan.set(Pass::splats, splat,
             plan.anew              ? Reason::light_changed
             : view                 ? Reason::other_view
             : !history.has_picture ? Reason::settings_changed
             : more                 ? Reason::twice_as_many
                                    : Reason::picture_holds);
    plan_mirror_rays<Pass, Reason>(plan, scene, settings, history.has_mirrors, view);
    plan_mirrors<Pass, Reason>(plan, plan.on(Pass::mirror_rays) || splat);
    return plan;
}

GiPlan in_words(const SplatPlan& plan, const GiSettings& settings) {
    return steps_in_words(
        plan, plan.bounces, kNames, [&](Pass pass) { return size(pass, plan, settings); },
        [&](Reason reason) { return why(reason, plan); });
}

GiPlan first_splat_plan(const FrameScene& scene, const GiSettings& settings) {
    return in_words(make_splat_plan(scene, settings, {}), settings);
}

}  // namespace lanthorn::gi
