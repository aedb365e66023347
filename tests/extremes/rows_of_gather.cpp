#include <map>

#include "lanthorn/emc/emc_settings.h"
#include "tests/extremes/row.h"

namespace lanthorn::extremes {

namespace {

const char* const kPeak = "half of the light leaves one lit texel, which few rays of a first frame meet";
const char* const kCell = "a cell of the sky, six degrees wide, that rays find by chance";
const char* const kSlits = "few maps see into an alcove: 1.52 of the ordinary error";
const char* const kEdges = "light leaks through map texels on the block's edges";

const std::map<std::string, std::vector<Defect>>& known_defects() {
    static const std::map<std::string, std::vector<Defect>> all = {
        {"bulb 5 mm off a sphere's wall", {{Bound::error, 0.29, kPeak}, {Bound::flux, 0.1, kPeak}}},
        {"a sky of one pixel of 1e6 nits", {{Bound::error, 0.36, kCell}}},
        {"k = 32, alcoves of 28 cm", {{Bound::error, 0.17, kSlits}}},
        {"a block inside out", {{Bound::flux, 0.065, kEdges}, {Bound::leak, 0.0145, kEdges}}},
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
