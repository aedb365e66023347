#include <map>

#include "lanthorn/emc/emc_settings.h"
#include "tests/extremes/row.h"

namespace lanthorn::extremes {

namespace {

const char* const kPeak = "light on a wall changes within a lit texel";
const char* const kFew = "a first frame's rays, where much of what they meet is small";
const char* const kGlow = "direct light on lit maps is that of the strongest emissive triangles alone";
const char* const kFarGlow = "direct light on lit maps of a surface so far off does not see the room's walls";
const char* const kCell = "a cell of the sky, six degrees wide, that rays find by chance";
const char* const kEdges = "light leaks through map texels on the block's edges";

const std::map<std::string, std::vector<Defect>>& known_defects() {
    static const std::map<std::string, std::vector<Defect>> all = {
        {"bulb 5 mm off a sphere's wall", {{Bound::error, 0.36, kPeak}, {Bound::flux, 0.345, kPeak}}},
        {"k = 32, twelve rooms", {{Bound::error, 0.21, kFew}}},
        {"k = 32, alcoves of 28 cm", {{Bound::error, 0.22, kFew}, {Bound::flux, 0.053, kFew}}},
        {"a sky of one pixel of 1e6 nits", {{Bound::error, 0.36, kCell}}},
        {"in a glowing box of 1000 m", {{Bound::error, 1, kFarGlow}, {Bound::flux, 1, kFarGlow}}},
        {"in a glowing box of 1e+06 m", {{Bound::error, 1, kFarGlow}, {Bound::flux, 1, kFarGlow}}},
        {"a block inside out", {{Bound::flux, 0.065, kEdges}}},
        {"crawl space of 8 x 0.2 x 8 m", {{Bound::error, 1, kGlow}, {Bound::flux, 1, kGlow}}},
    };
    return all;
}

}  // namespace

Row gathered(const Row& row) {
    Row result = row;
    result.settings.edit<gi::EmcSettings>().final_stage = gi::EmcFinal::gather;
    result.settings.edit<gi::EmcSettings>().gather_grid = 2;  // the rows' pictures are small
    result.settings.edit<gi::EmcSettings>().gather_points = 1;
    // As many reflections as what is right has.
    result.settings.edit<gi::EmcSettings>().gather_endless = false;
    result.seeds = 1;
    const auto known = known_defects().find(row.name);
    result.defects = known != known_defects().end() ? known->second : std::vector<Defect>{};
    return result;
}

}  // namespace lanthorn::extremes
