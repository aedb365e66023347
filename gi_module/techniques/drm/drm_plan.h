// The plan of `drm`: which passes run in a frame, and why. It becomes words only where it is printed.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gi_module/techniques/drm/drm_statistics.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/pass_steps.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// In the order they run in.
enum class DrmPass : std::uint8_t {
    lamp_pictures,
    samples,
    sample_pictures,
    acceleration_structure,
    mirrors,
    gather,
    lobes
};
inline constexpr std::size_t kDrmPasses = 7;

enum class DrmReason : std::uint8_t {
    no_frame_yet,
    no_indirect_light,  // DrmPlan::unlit
    sky_alone,
    no_emissive_surface,
    first_frame,
    light_or_surfaces_changed,
    pictures_hold,
    other_settings,
    samples_hold,
    samples_look_nowhere,
    samples_look,
    mirrors_are_off,
    nothing_mirrors,
    no_exact_rays,
    geometry_changed,
    structure_holds,
    mirrors_show_more,
    mirrors_hold,
    other_view,
    other_light,
    picture_holds,
    lobes_are_wide
};

// What the technique remembers from frames before and the plan depends on. Default: the first frame.
struct DrmHistory {
    bool has_samples = false;
    bool same_samples = false;  // they are of these settings
    bool same_pixels = false;   // the picture is of this size and, but for the samples, of these settings
    bool has_picture = false;
    bool has_mirrors = false;       // a picture of mirrors
    bool other_light_maps = false;  // though nothing in the scene has changed
    bool can_trace = false;         // the program has rays for mirrors
};

struct DrmPlan : PassSteps<DrmPass, DrmReason, kDrmPasses> {
    Unlit unlit = Unlit::no;
    int bounces = 0;       // 1, or 0 without light
    bool sky = false;      // there is one, which has no picture
    bool mirrors = false;  // there is something that mirrors, and rays for it
    bool lobes = false;    // there is something glossy
    bool shoot = false;    // mirrors: rays are followed anew, not lit anew alone
};

// Decides from the scene, the settings and the history alone. No GL, no memory, O(instances + lights).
DrmPlan make_drm_plan(const FrameScene& scene, const GiSettings& settings, const DrmHistory& history);

// The plan in words; `counted`: of the same frame.
GiPlan in_words(const DrmPlan& plan, const GiSettings& settings, const DrmStatistics& counted);
GiPlan first_drm_plan(const FrameScene& scene, const GiSettings& settings);

}  // namespace lanthorn::gi
