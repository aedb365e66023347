// The plan of `splat`: which passes run in a frame, and why. It becomes words only where it is
// printed.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/pass_steps.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// In the order they run in.
enum class SplatPass : std::uint8_t { surfaces, photons, item_buffer, splats, mirror_rays, mirrors };
inline constexpr std::size_t kSplatPasses = 6;

enum class SplatReason : std::uint8_t {
    no_frame_yet,
    no_indirect_light,  // SplatPlan::unlit
    first_frame,
    geometry_changed,
    geometry_holds,
    light_changed,
    settings_changed,
    picture_grows,
    picture_is_complete,
    disk_is_full,
    other_view,
    view_holds,
    twice_as_many,
    picture_holds,
    mirrors_are_off,
    nothing_mirrors,
    mirrors_show_more,
    mirrors_hold
};

// What the technique remembers from frames before and the plan depends on. Default: the first frame.
struct SplatHistory {
    std::uint64_t walks = 0;     // that there are photons of
    std::uint64_t splatted = 0;  // that were there when the picture was made
    bool has_photons = false;    // of the same settings
    bool has_picture = false;    // of the same settings and size
    bool has_view = false;       // an item buffer of the same size
    bool full = false;           // the disk takes no more
    bool has_mirrors = false;    // rays of pixels that mirror, of the same settings
};

struct SplatPlan : PassSteps<SplatPass, SplatReason, kSplatPasses> {
    Unlit unlit = Unlit::no;
    int bounces = 0;
    bool anew = false;        // what photons there are is forgotten
    std::uint64_t grow = 0;   // walks of this frame
    std::uint64_t walks = 0;  // with these
    bool mirrors = false;     // there is something that mirrors or is looked through
};

// Decides from the scene, the settings and the history alone. No GL, no memory, O(instances + lights).
SplatPlan make_splat_plan(const FrameScene& scene, const GiSettings& settings, const SplatHistory& history);

// The plan in words.
GiPlan in_words(const SplatPlan& plan, const GiSettings& settings);
GiPlan first_splat_plan(const FrameScene& scene, const GiSettings& settings);

}  // namespace lanthorn::gi
