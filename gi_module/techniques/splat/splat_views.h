// The debug views of `splat`.
#pragma once

#include <string_view>
#include <vector>

#include "gi_module/techniques/splat/photon_collection.h"
#include "gi_module/techniques/splat/picture_surfaces.h"
#include "gi_module/techniques/splat/splat_settings.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

std::vector<DebugView> splat_views();
// `powers`: by group of lights, as PhotonCollection::powers(). None where photons on disk could not be read.
gpu::Texture draw_splat_view(std::string_view name, PhotonCollection& photons, std::span<const vec3> powers,
                             const PictureSurfaces& picture, const SplatSurfaces& surfaces,
                             const SplatSettings& settings, const render::FrameInputs& inputs);

}  // namespace lanthorn::gi
