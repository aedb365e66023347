#include "gi_module/techniques/vertex-map/vertex_map_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "gi_module/shared/mirrors/mirror_plan.h"
#include "gi_module/shared/plan_rules.h"
#include "gi_module/shared/plan_words.h"
#include "gi_module/techniques/vertex-map/vertex_map_settings.h"

namespace lanthorn::gi {

namespace {

using Pass = VertexMapPass;
using Reason = VertexMapReason;

constexpr std::array<std::string_view, kVertexMapPasses> kNames = {"acceleration_structure",
                                                                   "photons",
                                                                   "tree",
                                                                   "corners",
                                                                   "seen",
                                                                   "mirror_rays",
                                                                   "estimates",
                                                                   "picture",
                                                                   "mirrors"};

// Of a pass that runs.
std::string size(Pass pass, const VertexMapPlan& plan, const VertexMapSettings& v) {
    switch (pass) {
        case Pass::photons:
            return fmt::format("{} of {}, {} hits each{}", plan.photons, v.total, plan.levels,
                               plan.direct ? ", direct light too" : "");
        case Pass::tree:
            return v.tree == TreeKind::kept ? "what came and went" : "all anew";
        case Pass::corners:
            return fmt::format("edges of {:g} of the diagonal, {} levels by photons", v.edge, v.density);
        case Pass::estimates:
            return fmt::format("{} nearest photons", v.nearest);
        case Pass::mirror_rays:
            return "a ray a pixel that mirrors or is looked through";
        case Pass::acceleration_structure:
        case Pass::seen:
        case Pass::picture:
        case Pass::mirrors:
            break;
    }
    return {};
}

std::string why(Reason reason, const VertexMapPlan& plan) {
    switch (reason) {
        case Reason::geometry_changed:
            return "something moved, came or went";
        case Reason::geometry_holds:
            return "no geometry changed: it holds";
        case Reason::photons_are_shot:
            return "photons are shot at it";
        case Reason::mirrors_are_followed:
            return "rays of mirrors are shot at it";
        case Reason::sensors_are_looked_at:
            return "rays find what light sensors lie on";
        case Reason::all_at_once:
            return "there are none yet: all of them";
        case Reason::oldest_first:
            return "light or geometry changed: the oldest are replaced";
        case Reason::photons_hold:
            return "all photons are of the scene as it is";
        case Reason::photons_changed:
            return "photons came and went";
        case Reason::refined:
            return "photons lie closer, or less close, than triangles are fine";
        case Reason::view_holds:
            return "neither camera nor triangles changed";
        case Reason::all_vertices:
            return "gi.vertex-map.skip is none";
        case Reason::by_facing:
            return "gi.vertex-map.skip is back_faces: told from the triangles";
        case Reason::newly_seen:
            return "of what was not seen before";
        case Reason::light_holds:
            return "every vertex seen has its light";
        case Reason::light_changed:
            return "light at vertices, or the view, is another";
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

VertexMapPlan make_vertex_map_plan(const FrameScene& scene, const GiSettings& settings,
                                   const VertexMapHistory& history) {
    VertexMapPlan plan;
    const LightBounds bounds = light_bounds(scene);
    plan.unlit = bounds.unlit;
    if (bounds.unlit != Unlit::no) {
        plan.steps.fill({false, Reason::no_indirect_light});
        return plan;
    }
    const auto& v = settings.of<VertexMapSettings>();
    const int most = std::min(settings.bounces, v.max_level - 1);
    plan.bounces = most > 0 ? planned_bounces(settings, bounds.carried, most) : 0;
    plan.levels = plan.bounces + 1;
    plan.direct = v.direct;

    const SceneChanges& changes = scene.changes;
    plan.begins_again = !history.has_photons || history.replaced;
    const bool first = plan.begins_again || !history.has_picture;
    plan.changed = plan.begins_again || !changes.nothing() || changes.assets;
    const auto total = static_cast<std::uint64_t>(v.total);
    const std::uint64_t left = plan.changed ? total : history.left;
    plan.photons = plan.begins_again ? total : std::min(left, static_cast<std::uint64_t>(v.per_frame));

    const bool geometry = first || changes.geometry || changes.assets;
    const bool shoot = plan.photons > 0;
    const bool corners = geometry || !history.has_estimates || history.refines;
    const bool view = first || corners || changes.camera;
    plan.set(Pass::photons, shoot,
             plan.begins_again ? Reason::all_at_once
             : shoot           ? Reason::oldest_first
                               : Reason::photons_hold);
    plan.set(Pass::tree, shoot, shoot ? Reason::photons_changed : Reason::photons_hold);
    plan.set(Pass::corners, corners,
             first                        ? Reason::first_frame
             : geometry                   ? Reason::geometry_changed
             : corners && history.refines ? Reason::refined
             : corners                    ? Reason::first_frame
                                          : Reason::geometry_holds);
    plan.set(Pass::seen, view && v.skip == SkippedVertices::hidden,
             v.skip == SkippedVertices::none         ? Reason::all_vertices
             : v.skip == SkippedVertices::back_faces ? Reason::by_facing
             : view                                  ? Reason::other_view
                                                     : Reason::view_holds);
    plan_mirror_rays<Pass, Reason>(plan, scene, settings, history.has_mirrors,
                                   first || geometry || changes.camera);
    const bool rays = plan.on(Pass::mirror_rays), sensors = !scene.sensors.empty();
    plan.set(Pass::acceleration_structure, shoot || rays || sensors,
             plan.begins_again  ? Reason::first_frame
             : changes.geometry ? Reason::geometry_changed
             : shoot            ? Reason::photons_are_shot
             : rays             ? Reason::mirrors_are_followed
             : sensors          ? Reason::sensors_are_looked_at
                                : Reason::geometry_holds);
    const bool estimates = shoot || view || plan.on(Pass::mirror_rays);
    plan.set(Pass::estimates, estimates,
             shoot       ? Reason::photons_changed
             : estimates ? Reason::newly_seen
                         : Reason::light_holds);
    plan.set(Pass::picture, estimates, estimates ? Reason::light_changed : Reason::picture_holds);
    plan_mirrors<Pass, Reason>(plan, plan.on(Pass::mirror_rays) || estimates);
    return plan;
}

GiPlan in_words(const VertexMapPlan& plan, const GiSettings& settings) {
    return steps_in_words(
        plan, plan.bounces, kNames,
        [&](Pass pass) { return size(pass, plan, settings.of<VertexMapSettings>()); },
        [&](Reason reason) { return why(reason, plan); });
}

GiPlan first_vertex_map_plan(const FrameScene& scene, const GiSettings& settings) {
    return in_words(make_vertex_map_plan(scene, settings, {}), settings);
}

}  // namespace lanthorn::gi
