// The debug views of `drm`.
#pragma once

#include <string_view>
#include <vector>

#include "gi_module/techniques/drm/radiance_map.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

std::vector<DebugView> drm_views();
// `settings`: those that the map was made with. Waits for the GPU.
gpu::Texture draw_drm_view(std::string_view name, const RadianceMap& map, const DrmSettings& settings,
                           const render::FrameInputs& inputs);

}  // namespace lanthorn::gi
