// What mirrors need of a frame, for the plans of techniques that follow their rays on the processor: pass
// `mirrors`, `mirror_rays` where rays have a pass of their own, and the reasons that go with them, by these
// names in each one's enums.
#pragma once

#include <optional>

#include "gi_module/shared/mirrors/mirror_view.h"
#include "lanthorn/gi/gi_settings.h"

namespace lanthorn::gi {

// Why no rays are followed; none: they are. O(instances).
template <class Reason>
std::optional<Reason> without_mirrors(const FrameScene& scene, const GiSettings& settings) {
    if (!(settings.specular_roughness > 0)) {
        return Reason::mirrors_are_off;
    }
    if (!any_specular(scene, settings.specular_roughness)) {
        return Reason::nothing_mirrors;
    }
    return {};
}

// Decides about the rays, and whether there are mirrors at all (plan.mirrors). `followed`: rays of frames
// before are remembered, of these settings. `view`: other surfaces, or they are seen from elsewhere.
template <class Pass, class Reason, class Plan>
void plan_mirror_rays(Plan& plan, const FrameScene& scene, const GiSettings& settings, bool followed,
                      bool view) {
    const std::optional<Reason> without = without_mirrors<Reason>(scene, settings);
    plan.mirrors = !without;
    if (without) {
        plan.set(Pass::mirror_rays, false, *without);
        plan.set(Pass::mirrors, false, *without);
        return;
    }
    const SceneChanges& changes = scene.changes;
    const bool rays = view || !followed || changes.relief || changes.assets || changes.pattern ||
                      changes.emission || !changes.painted.empty();
    plan.set(Pass::mirror_rays, rays,
             !followed ? Reason::first_frame
             : rays    ? Reason::other_view
                       : Reason::view_holds);
}

// Then whether what they meet is lit anew; `anew`: it is met by other rays or may be lit otherwise.
template <class Pass, class Reason, class Plan>
void plan_mirrors(Plan& plan, bool anew) {
    if (plan.mirrors) {
        plan.set(Pass::mirrors, anew, anew ? Reason::mirrors_show_more : Reason::mirrors_hold);
    }
}

// Words for those reasons; empty for others.
template <class Reason>
std::string_view mirror_words(Reason reason) {
    switch (reason) {
        case Reason::mirrors_are_off:
            return "gi.specular.roughness is 0";
        case Reason::nothing_mirrors:
            return "no surface is smooth enough or transparent";
        case Reason::mirrors_show_more:
            return "view, light or surfaces changed";
        case Reason::mirrors_hold:
            return "they show what they did";
        default:
            return {};
    }
}

}  // namespace lanthorn::gi
