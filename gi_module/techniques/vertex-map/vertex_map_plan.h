// The plan of `vertex-map`: which passes run in a frame, and why. It becomes words only where it is
// printed.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/pass_steps.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// In the order they run in; the first three are the thesis's first two stages.
enum class VertexMapPass : std::uint8_t {
    acceleration_structure,
    photons,
    tree,
    corners,
    seen,
    mirror_rays,
    estimates,
    picture,
    mirrors
};
inline constexpr std::size_t kVertexMapPasses = 9;

enum class VertexMapReason : std::uint8_t {
    no_frame_yet,
    no_indirect_light,  // VertexMapPlan::unlit
    first_frame,
    geometry_changed,
    geometry_holds,
    photons_are_shot,
    mirrors_are_followed,
    sensors_are_looked_at,
    all_at_once,
    oldest_first,
    photons_hold,
    photons_changed,
    refined,
    other_view,
    view_holds,
    all_vertices,
    by_facing,
    newly_seen,
    light_holds,
    picture_holds,
    light_changed,
    mirrors_are_off,
    nothing_mirrors,
    mirrors_show_more,
    mirrors_hold
};

// What the technique remembers from frames before and the plan depends on. Default: the first frame.
struct VertexMapHistory {
    bool has_picture = false;    // of the same size
    bool has_photons = false;    // by the same settings
    bool has_estimates = false;  // by the same settings
    bool refines = false;        // triangles are split otherwise than in the picture
    bool has_mirrors = false;    // rays of pixels that mirror, of the same settings
    std::uint64_t left = 0;      // photons that were shot before the last change
    bool replaced = false;       // nothing of the scene is what it was
};

struct VertexMapPlan : PassSteps<VertexMapPass, VertexMapReason, kVertexMapPasses> {
    Unlit unlit = Unlit::no;
    int bounces = 0;            // reflections before the visible surface
    int levels = 0;             // hits of a photon; 0: there is no light
    bool changed = false;       // light or geometry: all photons are old
    bool begins_again = false;  // nothing of before is kept
    bool mirrors = false;       // there is something that mirrors or is looked through
    bool direct = false;        // photons bring direct light, too
    std::uint64_t photons = 0;  // that are shot
};

// Decides from the scene, the settings and the history alone. No GL, no memory, O(instances + lights).
VertexMapPlan make_vertex_map_plan(const FrameScene& scene, const GiSettings& settings,
                                   const VertexMapHistory& history);

// The plan in words.
GiPlan in_words(const VertexMapPlan& plan, const GiSettings& settings);
GiPlan first_vertex_map_plan(const FrameScene& scene, const GiSettings& settings);

}  // namespace lanthorn::gi
