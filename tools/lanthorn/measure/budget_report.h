// What `lanthorn measure budget` tells of a run.
#pragma once

#include <string>

#include "tools/lanthorn/common/workbench.h"
#include "tools/workbench/measure/measure_budget.h"

namespace lanthorn::tools {

// A line a frame.
std::string budget_csv(const BudgetRecord& record);
// Three strips over the frames: milliseconds, the estimated error, and what is spared; decisions are numbered
// and told below.
std::string budget_svg(const BudgetRecord& record, const BudgetRunJob& job, const std::string& title);
// Percentiles, what is used of the budget, and each decision.
std::string budget_text(const BudgetRecord& record, const BudgetRunJob& job);

}  // namespace lanthorn::tools
