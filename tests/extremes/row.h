// A row of the table: a scene, settings, what must run, what is right, and how far off it may be.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_settings.h"
#include "tests/extremes/stage.h"

namespace lanthorn::extremes {

// What "ordinary" means for a row: the error of these at ordinary numbers is the measure of all others.
enum class Ordinary { room, sphere };

// What the image is compared with.
enum class Right {
    ordinary,  // the ordinary scene's truth, times Row::gain
    traced,    // the path-traced reference of the row's own scene
    constant,  // Row::lux everywhere
};

// What of a row is bounded from above. A floor (maps, arrivals, dark) says what the row looks at and has no
// defects.
enum class Bound { error, flux, unlike, lost, leak };

// Known: the row breaks this bound, by that much and no more. It is red, too, when the bound holds again.
struct Defect {
    Bound bound;
    double ceiling;  // of the measured value, absolute: relRMSE, not ordinary errors
    std::string why;
};

inline gi::GiSettings by_splats() {
    gi::GiSettings settings;
    settings.edit<gi::EmcSettings>().final_stage = gi::EmcFinal::splat;
    return settings;
}

struct Row {
    std::string name;
    std::function<Stage()> stage;
    Placement placement;
    gi::GiSettings settings = by_splats();
    ivec2 size{96};
    int spp = 64;   // of the traced truth
    int seeds = 1;  // of photons and candidates: what is judged are means over them, where one alone is luck

    Ordinary ordinary = Ordinary::room;
    Right right = Right::traced;
    double gain = 1;
    double lux = 0;

    int bounces = 2;     // that the plan must trace; 0: the plan must say that nothing can be lit, and why
    int least_maps = 2;  // environment maps that must be in use
    double error = 1.5;  // bound of the relRMSE, in ordinary errors
    double flux = 0.05;  // bound of |flux ratio - 1|
    double lost = 0.02;  // bound of the share of photons that no map had a hit for, a bounce
    double unlike = 2;   // Right::ordinary: bound of the relRMSE against the ordinary image itself; 2: none
    std::uint64_t least_stored = 1;  // arrivals of photons, at least
    double dark = 0;                 // share of the picture, at least, that no light reaches
    double leak = 0.01;              // bound of the mean where no light reaches, over the picture's mean
    std::string reason;              // why a bound is not the usual one
    std::vector<Defect> defects;     // bounds that are broken; all others hold
};

// A row's name as GoogleTest takes it.
std::string plain(const std::string& name);

// The row by gi.emc.final = gather, with that stage's own defects. It has the bounds of error, flux and leak;
// the measure of its error stays the ordinary scene by splats.
Row gathered(const Row& row);

std::vector<Row> rows_of_placement();
std::vector<Row> rows_of_light();
std::vector<Row> rows_of_counts();
std::vector<Row> rows_of_views();
std::vector<Row> rows_of_triangles();
std::vector<Row> rows_of_rooms();
std::vector<Row> rows_of_skies();
std::vector<Row> rows_of_lamps();  // by the shipped default alone

}  // namespace lanthorn::extremes
