// How much of each effect of light a technique has, beside the path-traced reference.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/core/settings.h"
#include "lanthorn/workbench/load_scene.h"

namespace lanthorn::workbench {

// What is rendered to measure effects.
struct EffectsJob {
    SceneView view;
    ivec2 size{128};
    int frames = 8;  // of the technique
    int spp = 256;   // of the reference, with all that materials say
};

// Means over the pixels that show it, luminance.
struct Effect {
    std::string name;
    std::string unit;  // lx: irradiance of what scatters light; nt: radiance as it is shown
    double share = 0;  // of the picture that shows it
    double technique = 0, reference = 0;

    // 1: as bright as the reference. Infinite or NaN where the reference is black.
    double ratio() const { return technique / reference; }
};

// How far the place where caustics are brightest is from the reference's, in shares of the scene's diagonal.
struct CausticPeak {
    double off = 0;
    double halves = 0;  // two halves of the reference from each other: what their noise leaves uncertain
};

// Each effect beside the reference's, in one picture.
struct Effects {
    std::vector<Effect> parts;
    std::optional<CausticPeak> peak;  // none without caustics on what scatters light
};

// Indirect light of what scatters it, apart: caustics (light that has met smooth metal or glass on its way),
// the sky's (what the scene without it lacks) and the rest; and what is shown by metal, by what transmits, by
// what emits, behind everything, and in all. Effects that the picture does not have are left out. `scene` is
// asked for several times, and must give the same. `done` is told how many of 8 pictures are there;
// the reference's are means of two halves.
Effects measure_effects(const std::function<SceneData()>& scene, const Settings& settings,
                        const EffectsJob& job, const std::function<void(std::uint64_t)>& done);

}  // namespace lanthorn::workbench
