#include "gi_module/techniques/vertex-map/vertex_views.h"

#include <algorithm>

#include "gi_module/shared/debug/debug_picture.h"

namespace lanthorn::gi {

namespace {

using Shown = DebugView::Shown;

}  // namespace

std::vector<DebugView> vertex_map_views() {
    return {{"vertices", "the points that light is estimated at, with their irradiance", "lux", Shown::light},
            {"photons", "the photons in the tree, in the colour of their light", "", Shown::colour}};
}

gpu::Texture draw_vertex_map_view(std::string_view name, const VertexScene& vertices,
                                  std::span<const vec4> light, const PhotonStore& photons,
                                  const render::FrameInputs& inputs) {
    const SeenPoints seen(inputs);
    DebugPicture picture(seen.size());
    if (name == "vertices") {
        std::vector<vec3> positions;
        vertices.list_positions(positions);
        for (std::size_t i = 0; i < std::min(positions.size(), light.size()); ++i) {
            seen.draw(picture, positions[i], vec3(light[i]), 2 * seen.point_side());
        }
    } else {
        for (const StoredPhoton& photon : photons.places()) {
            if (photon.used) {
                seen.draw(picture, photon.position, hue_of(photon.flux), seen.point_side());
            }
        }
    }
    return picture.texture();
}

}  // namespace lanthorn::gi
