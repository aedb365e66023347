// The plan: which passes of the indirect light run, with which sizes, and why, written down before any work.
#pragma once

#include <string>
#include <vector>

#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

struct PlanEntry {
    std::string pass;
    bool on = false;
    std::string size;  // as in "8 maps x 6 x 128^2"; empty where a pass has none
    std::string why;   // one line
};

// What a technique remembers from frames before and the plan depends on. Default: the first frame.
struct GiHistory {
    bool has_maps = false;          // environment maps are there
    bool has_photons = false;       // photons of an unchanged scene are there
    bool has_image = false;         // an irradiance image of an unchanged scene and camera is there
    int round = 0;                  // frames of the progressive update under way, before this one
    bool geometry_pending = false;  // geometry has changed since the last progressive update began to look
    bool fading = false;            // a map is being exchanged
    int passes = 0;                 // that the image is the mean of
    bool has_lit = false;           // lit maps of unchanged surfaces are there
    int texel_frames = 0;           // frames of rays remembered from the lit maps
    int point_frames = 0;           // frames of rays remembered from the picture
    Aabb chosen_for;                // render space: the scene's bounds when maps were chosen
};

struct GiPlan {
    std::vector<PlanEntry> entries;
    int bounces = 0;           // bounces that are traced
    bool select_maps = false;  // initial selection (candidates, coverage, greedy choice, refinement)
    int share = -1;            // share of the candidates that is seen anew; -1: none
    int shares = 0;            // in all
    bool update_maps = false;  // progressive update: all have been seen, one map may be exchanged
    bool draw_maps = false;    // maps follow what moved
    bool trace = false;        // emission, bounces
    int pass = 0;              // passes of a still picture traced before this frame's photons
    bool gather = false;       // splats, or the final gather, and up-sampling

    // Of gi.emc.final = gather alone.
    bool list_texels = false;   // the maps show other surfaces: which texels are lit
    bool light_texels = false;  // direct light on them anew
    bool texel_rays = false;    // a frame more of rays from them
    bool list_points = false;   // another view, or other surfaces: points of the picture anew
    bool point_rays = false;    // a frame more of rays from them

    bool on(const std::string& pass) const;
    // Nothing is traced or gathered after all.
    void give_up(const std::string& why);
};

// Frames that the look of a progressive update is spread over: the last ones of its interval.
int update_shares(const GiSettings& settings);

// Why no surface of the scene can reflect light, in one line; empty if some can. O(instances + lights).
std::string no_indirect_light(const FrameScene& scene);
// How many of `limit` bounces can still matter, at least 1: light after b of them is at most the brightest
// albedo^b of what was emitted. O(instances).
int useful_bounces(const FrameScene& scene, int limit);

// Decides from the scene, the settings and the history alone. No GL, O(instances + lights).
GiPlan make_plan(const FrameScene& scene, const GiSettings& settings, const GiHistory& history);

// A readable table and a JSON array of {pass, on, size, why}.
std::string plan_table(const GiPlan& plan);
std::string plan_json(const GiPlan& plan);

}  // namespace lanthorn::gi
