// The plan of `splat`: which passes run in a frame, and why. The words for it are made for whom it is
// printed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/plan.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// In the order they run in.
enum class SplatPass : std::uint8_t { surfaces, photons, item_buffer, splats };
inline constexpr std::size_t kSplatPasses = 4;

enum class SplatReason : std::uint8_t {
    no_frame_yet,
    no_indirect_light,  // PhotonSplatPlan::unlit
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
    picture_holds
};

// What the technique remembers from frames before and the plan depends on. Default: the first frame.
struct SplatHistory {
    std::uint64_t walks = 0;     // that there are photons of
    std::uint64_t splatted = 0;  // that were there when the picture was made
    bool has_photons = false;    // of the same settings
    bool has_picture = false;    // of the same settings and size
    bool has_view = false;       // an item buffer of the same size
    bool full = false;           // the disk takes no more
};

struct PhotonSplatPlan {
    struct Step {
        bool on = false;
        SplatReason why = SplatReason::no_frame_yet;
    };
    std::array<Step, kSplatPasses> steps;  // by SplatPass

    Unlit unlit = Unlit::no;
    int bounces = 0;
    bool anew = false;        // what photons there are is forgotten
    std::uint64_t grow = 0;   // walks of this frame
    std::uint64_t walks = 0;  // with these

    bool on(SplatPass pass) const { return steps[static_cast<std::size_t>(pass)].on; }
    void set(SplatPass pass, bool on, SplatReason why) { steps[static_cast<std::size_t>(pass)] = {on, why}; }
};

// Decides from the scene, the settings and the history alone. No GL, no memory, O(instances + lights).
PhotonSplatPlan make_photon_splat_plan(const FrameScene& scene, const GiSettings& settings,
                                       const SplatHistory& history);

// The plan in words.
GiPlan in_words(const PhotonSplatPlan& plan, const GiSettings& settings);
GiPlan first_photon_splat_plan(const FrameScene& scene, const GiSettings& settings);

}  // namespace lanthorn::gi
