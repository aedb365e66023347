// What the plans of all techniques share: the form they are printed in, and what can be said of a scene's
// indirect light before any technique is asked. How a technique decides lies with it (emc/emc_plan.h).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// One pass of a GiPlan in words.
struct PlanEntry {
    std::string pass;
    bool on = false;
    std::string size;  // as in "8 maps x 6 x 128^2"; empty where a pass has none
    std::string why;   // one line
};

// Which passes of the indirect light run in a frame, with which sizes, and why, in words. It is made
// when it is shown, from what the technique has decided.
struct GiPlan {
    std::vector<PlanEntry> entries;
    int bounces = 0;  // that are traced

    // Whether the pass of that name runs; false where the plan has none of that name. O(entries).
    bool on(std::string_view pass) const;
};

// A readable table, one line a pass: its name, on or off, size and why.
std::string plan_table(const GiPlan& plan);
// The same as a JSON array of {pass, on, size, why}, on one line.
std::string plan_json(const GiPlan& plan);

// Why a scene has no indirect light.
enum class Unlit { no, no_geometry, no_light, nothing_reflects };

// Estimated shares, 0..1, of the light that a scene emits which leave its surfaces after the first, second,
// ... reflection.
using CarriedLight = std::array<float, 8>;

// What bounds a scene's indirect light.
struct LightBounds {
    Unlit unlit = Unlit::no;
    float albedo = 0;        // of the brightest diffuse surface, 0..1
    bool lamps = false;      // something else than the sky shines
    CarriedLight carried{};  // of a scene with indirect light
};

// O(instances x 16 + lights).
LightBounds light_bounds(const FrameScene& scene);
// One line.
std::string_view words(Unlit unlit);

// How many of `limit` reflections can still matter, at least 1: those that carry more than a 500th of the
// light. `before`: how many there were in the frame before, 0 without one; they are given up where they carry
// less than half of that, so that light which comes and goes about it does not switch one on and off.
int useful_bounces(const CarriedLight& carried, int limit, int before = 0);

}  // namespace lanthorn::gi
