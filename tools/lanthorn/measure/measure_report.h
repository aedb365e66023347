// The figures of `lanthorn measure` for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lanthorn/workbench/measure_coverage.h"
#include "lanthorn/workbench/measure_effects.h"
#include "lanthorn/workbench/measure_energy.h"
#include "lanthorn/workbench/measure_flicker.h"
#include "lanthorn/workbench/measure_hits.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {

// JSON has neither NaN nor infinity: null.
nlohmann::ordered_json json_number(double value);

struct MeasureReport {
    std::string table;               // readable text, lines end in a newline
    nlohmann::ordered_json figures;  // what cannot be told is null
};

MeasureReport report(const std::vector<HitCounts>& bounces);
MeasureReport report(const CoverageFigures& figures);
MeasureReport report(const EnergyBalance& balance);
MeasureReport report(const FlickerFigures& figures);
MeasureReport report(const Effects& effects);

}  // namespace lanthorn::tools
