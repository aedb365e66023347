// The sub-command `motions` of `lanthorn measure`, and its two ways to tell what was found.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lanthorn/workbench/measure_motions.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {

Command add_measure_motions(CLI::App& measure);

using MotionResults = std::vector<std::vector<MotionFigures>>;  // by case, by motion
// A row a figure, a column a case; lines end in a newline.
std::string motions_table(const MotionScene& scene, const std::vector<MotionCase>& cases,
                          const MotionResults& results, const MotionJob& job, int spp);
nlohmann::ordered_json motions_json(const MotionScene& scene, const std::vector<MotionCase>& cases,
                                    const MotionResults& results);

}  // namespace lanthorn::tools
