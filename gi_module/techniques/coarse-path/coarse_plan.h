// The plan of `coarse-path`: which passes run in a frame, and why. It becomes words only where it is
// printed.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/pass_steps.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// In the order they run in.
enum class CoarsePass : std::uint8_t { acceleration_structure, points, paths, history, filter, upsampling };
inline constexpr std::size_t kCoarsePasses = 6;

enum class CoarseReason : std::uint8_t {
    no_frame_yet,
    no_indirect_light,  // CoarsePlan::unlit
    first_frame,
    geometry_changed,
    geometry_holds,
    other_view,
    points_hold,
    light_changed,
    mean_grows,
    picture_is_complete,
    old_light_must_go,
    nothing_moves,
    paths_are_noisy,
    other_filter,
    picture_holds,
    from_grid,
    full_resolution
};

// What the technique remembers from frames before and the plan depends on. Default: the first frame.
struct CoarseHistory {
    bool has_picture = false;
    bool has_samples = false;  // of the same settings and size
    bool filtered = false;     // the picture is, by the same settings
    int still_frames = 0;      // since light or geometry changed
};

struct CoarsePlan : PassSteps<CoarsePass, CoarseReason, kCoarsePasses> {
    Unlit unlit = Unlit::no;
    int bounces = 0;
    int still_frames = 0;  // with this one
    int kept = 0;          // frames whose samples are kept
};

// Decides from the scene, the settings and the history alone. No GL, no memory, O(instances + lights).
CoarsePlan make_coarse_plan(const FrameScene& scene, const GiSettings& settings,
                            const CoarseHistory& history);

// The plan in words.
GiPlan in_words(const CoarsePlan& plan, const GiSettings& settings);
GiPlan first_coarse_plan(const FrameScene& scene, const GiSettings& settings);

}  // namespace lanthorn::gi
