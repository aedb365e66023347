// The plan of `path`: which passes run in a frame, and why. It becomes words only where it is printed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "gi_module/shared/stamps.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/pass_steps.h"
#include "lanthorn/reference/path_settings.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// In the order they run in.
enum class PathPass : std::uint8_t { acceleration_structure, first_surfaces, paths };
inline constexpr std::size_t kPathPasses = 3;

// What passes are made from.
enum class PathInput : std::uint8_t { geometry, surfaces, lights, view, settings };
inline constexpr std::size_t kPathInputs = 5;
using PathStamps = Stamps<PathInput, kPathInputs>;

enum class PathReason : std::uint8_t {
    no_frame_yet,
    no_indirect_light,  // PathPlan::unlit
    none_yet,
    geometry_changed,
    surfaces_changed,
    light_changed,
    other_view,
    other_settings,
    holds,
    mean_grows,
    spp_reached,
    noise_reached
};

// What there is of the frames before. Default: nothing.
struct PathPictures {
    PathStamps structure{PathInput::geometry, PathInput::surfaces};
    PathStamps first_surfaces{PathInput::geometry, PathInput::surfaces, PathInput::view};
    PathStamps paths{PathInput::geometry, PathInput::surfaces, PathInput::lights, PathInput::view,
                     PathInput::settings};
    int spp = 0;                                             // of `paths`
    double noise = std::numeric_limits<double>::infinity();  // of these, as last looked at
};

struct PathPlan : PassSteps<PathPass, PathReason, kPathPasses> {
    Unlit unlit = Unlit::no;
    bool begins_again = false;  // the samples so far are of something else
    int from_spp = 0;           // samples that there are
    int frame_spp = 0;          // that are added
};

// `settings`: with the bounces and the seed of GiSettings. No GL, no memory, O(instances + lights).
PathPlan make_path_plan(const FrameScene& scene, const reference::PathSettings& settings,
                        const PathStamps::Versions& now, const PathPictures& known);

// The plan in words.
GiPlan in_words(const PathPlan& plan, const reference::PathSettings& settings);
GiPlan first_path_plan(const FrameScene& scene, const GiSettings& settings);

// The settings of `path` as a frame's samples are taken by them, settled() for a picture.
reference::PathSettings path_settings(const GiSettings& settings);

}  // namespace lanthorn::gi
