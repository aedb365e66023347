// The debug views of `vertex-map`.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "gi_module/techniques/vertex-map/photon_store.h"
#include "gi_module/techniques/vertex-map/vertex_scene.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

std::vector<DebugView> vertex_map_views();
// `light`: by corner, as VertexScene::list_light().
gpu::Texture draw_vertex_map_view(std::string_view name, const VertexScene& vertices,
                                  std::span<const vec4> light, const PhotonStore& photons,
                                  const render::FrameInputs& inputs);

}  // namespace lanthorn::gi
