// The debug views of `coarse-path`.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "gi_module/techniques/coarse-path/point_history.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

std::vector<DebugView> coarse_views();
// `estimates`: of each of `points`.
gpu::Texture draw_coarse_view(std::string_view name, const GridPoints& points,
                              std::span<const PointEstimate> estimates);

}  // namespace lanthorn::gi
