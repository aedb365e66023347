// The rules by which plans leave work out, each with a switch: off, the plan works as if the scene required
// it, so that what the rule saves and what it costs in error can be measured (`lanthorn measure plan`).
#pragma once

#include <array>

#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/plan.h"

namespace lanthorn::gi {

struct PlanRules {
    bool bounces = true;   // reflections that cannot carry a share of the light are not traced
    bool count = true;     // no map that adds no coverage
    bool maps = true;      // maps are drawn where something has moved
    bool rounds = true;    // candidates are looked at while things move
    bool light = true;     // what stays lit as it was is not lit again
    bool picture = true;   // a picture that shows nothing new is not made again
    bool caustics = true;  // caustics hold while what makes them does
    bool mirrors = true;   // mirrors are followed where there are some and what they show has changed

    bool operator==(const PlanRules&) const = default;
};

// One of them, for lists and settings.
struct PlanRule {
    const char* name;  // of its setting
    bool PlanRules::*on;
    const char* leaves_out;  // what is left out, and when: half a sentence
};
inline constexpr std::array<PlanRule, 8> kPlanRules = {{
    {"gi.plan.bounces", &PlanRules::bounces,
     "reflections that carry less than a 500th of the light, estimated by areas, albedos and what lamps "
     "reach"},
    {"gi.plan.count", &PlanRules::count,
     "maps that would show less than a 10 000th of what the first one shows and no other does"},
    {"gi.plan.maps", &PlanRules::maps, "faces of maps in which nothing has moved"},
    {"gi.plan.rounds", &PlanRules::rounds,
     "looks at candidates, after a round without an exchange since geometry changed"},
    {"gi.plan.light", &PlanRules::light,
     "light on the maps' texels, or photons, where neither lamps nor surfaces nor what casts shadows "
     "changed"},
    {"gi.plan.picture", &PlanRules::picture,
     "gather and filter, or splats, in a frame whose light, rays and view are those of the frame before"},
    {"gi.plan.caustics", &PlanRules::caustics,
     "caustic photons and their splats, while lamps, geometry and materials hold"},
    {"gi.plan.mirrors", &PlanRules::mirrors,
     "rays of mirrors and glass where none is seen, or while view and geometry hold"},
}};

// useful_bounces(), unless that rule is off.
inline int planned_bounces(const GiSettings& settings, const CarriedLight& carried, int limit,
                           int before = 0) {
    return settings.of<PlanRules>().bounces ? useful_bounces(carried, limit, before) : limit;
}

}  // namespace lanthorn::gi
