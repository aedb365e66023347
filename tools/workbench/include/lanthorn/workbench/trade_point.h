// The points of the speed-for-accuracy chart: which settings are measured, and what was found.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/core/settings.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::workbench {

// What changes in each frame.
enum class TradeMotion {
    light,   // light alone
    lamp,    // Motion::lamp: lamps move, meshes that shine too
    walk,    // Motion::walk: the camera alone
    box,     // Motion::box: a box that is put into the scene moves
    figure,  // Motion::figure: the scene's animation plays
};
// As --motion has them.
inline constexpr std::array<std::string_view, 5> kTradeMotionNames = {"light", "lamp", "walk", "box",
                                                                      "figure"};
// As `--motion` takes it, and files say it.
std::string name_of(TradeMotion motion);
// Throws InputError, which lists the names, for another.
TradeMotion trade_motion_named(std::string_view name);

// One way of lighting one scene.
struct TradePoint {
    std::string scene;                     // as listed_scene() takes it
    std::string technique;                 // as in gi.technique
    std::string preset;                    // what the settings start from
    std::vector<std::string> common;       // "KEY=VALUE" that every point has
    std::vector<std::string> assignments;  // "KEY=VALUE" that make this point; none: the preset itself
    std::string name = {};                 // what the chart calls it; empty: by its settings
    std::string stage = {};                // of other_final_stage(): which it has instead
    TradeMotion motion = TradeMotion::light;

    std::string scene_name() const;  // ListedScene's, "-figure" behind it where that is the motion
    std::string panel() const;       // the same for all points of a scene and a motion
    std::string label() const;  // "high", "coarse-path high", "medium, gi.photons=40000", "path, path.spp=4"
    std::string knob() const;   // the settings assigned: "gi.photons"; "preset" if none is
    Settings settings(const SettingsSchema& schema) const;  // throws InputError for what is not declared
};

// Milliseconds a frame over the measured frames.
struct Spread {
    double median = 0, p95 = 0, min = 0;
};
Spread spread_of(std::vector<double> values);  // at least one; nearest rank

// What one point costs and how far it is from the reference.
struct TradeFigures {
    Spread gi;           // wall clock (GL timer queries on real hardware) of the indirect light
    Spread gi_cpu;       // processor time of all threads for the same
    Spread frame;        // wall clock of the whole frame
    Spread direct;       // wall clock of the frame without its indirect light
    Spread ratio;        // indirect over direct of the same frame, wall clock
    Spread ratio_cpu;    // the same of processor time
    double cost_ms = 0;  // what the chart is drawn against: gi_cpu where the rasteriser is software, else gi
    double relrmse = 0;  // indirect, against the reference of the same bounces, its noise taken off
    double flux = 0;     // of the same two images
    double relrmse_all = 0;  // against all bounces there are
    double flux_all = 0;
    double flip = 0;             // mean LDR-FLIP of the final picture against all bounces
    double reference_noise = 0;  // relRMSE of the reference of the same bounces against the truth
    double photons_stored = 0, photons_lost = 0;
    double gpu_mb = 0;
    double rss_mb = 0;  // the most that the point's process had in memory until its last frame was shown
    double nan_count = 0;
    // Over how many seeds all these are medians, and the least and the largest relrmse among them.
    double seeds = 1, relrmse_least = 0, relrmse_most = 0;
    std::string renderer;  // GL_RENDERER; "Embree" for path
};

// What a point has come to.
struct TradeResult {
    TradePoint point;
    TradeFigures figures;
    std::string picture;  // PNG bytes: the picture and, beside it, its error
    std::string lost;     // why there are no figures; empty: there are
    bool on_front = false;

    // Whether there are figures.
    bool measured() const { return lost.empty(); }
};

// One point from the same point measured with several seeds, at least one: the median of each figure, the
// spread of relrmse; the first's picture and renderer. Lost if one is.
TradeResult over_seeds(const std::vector<TradeResult>& of_seeds);

// Figures as a JSON object, indented, with a line break at its end.
std::string figures_json(const TradeFigures& figures);
// The figures that figures_json() wrote. Throws InputError, which names `source`, for anything else.
TradeFigures figures_from_json(const std::string& json, const std::string& source);

// A setting and the values it takes, as in "KEY=V1,V2,...".
using Knob = gi::TurnedSetting;
// Throws InputError unless the setting is declared and each value is one it can take.
Knob parse_knob(const std::string& text, const SettingsSchema& schema);

// Which points of quality and time are measured.
struct Sweep {
    std::vector<std::string> scenes, techniques, presets;
    std::vector<TradeMotion> motions = {TradeMotion::light};
    std::string around = "medium";    // the preset that knobs are turned from
    std::vector<Knob> knobs;          // empty: what the technique's entry says
    bool presets_only = false;        // turn no knobs
    bool own_stage = false;           // of emc's presets no other_final_stage() and no papers_own_way()
    bool product = false;             // all combinations of the knobs instead of one at a time
    std::vector<std::string> common;  // settings of every point
};

// How Yao et al. 2010 find hits and show them: false position on raw distances, epsilon of eq. 2 as theirs,
// every map asked, photons splatted onto the picture. In every sweep with presets of emc, beside them.
TradePoint papers_own_way(TradePoint start);
// A preset of emc with the final stage that it does not have. In every sweep beside the preset itself.
TradePoint other_final_stage(TradePoint preset, const SettingsSchema& schema);

// Points in order, none twice by its settings. A knob that a technique does not read is left out for it.
// Throws InputError for a sweep without points.
std::vector<TradePoint> sweep_points(const Sweep& sweep, const SettingsSchema& schema);

// Which results no other of the same scene and motion betters: by cost and error (members of TradeFigures),
// one at least strictly. Lost points never are. O(n log n).
std::vector<bool> pareto_front(const std::vector<TradeResult>& results, double TradeFigures::*error,
                               double TradeFigures::*cost = &TradeFigures::cost_ms);

}  // namespace lanthorn::workbench
