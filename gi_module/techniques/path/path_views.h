// The debug views of `path`.
#pragma once

#include <string_view>
#include <vector>

#include "gi_module/reference/pixel_samples.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

std::vector<DebugView> path_views();
gpu::Texture draw_path_view(std::string_view name, const reference::PixelSamples& samples);

}  // namespace lanthorn::gi
