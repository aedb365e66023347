#include "engine/render/detail_hints.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::render {

double cube_samples_per_radian(int resolution) {
    return 2.0 * resolution / static_cast<double>(kPi);
}

void add_camera(DetailHints& hints, const CameraView& view, const dvec3& origin, int height) {
    const Camera& camera = view.camera;
    if (camera.orthographic) {
        hints.samples_per_metre = std::max(hints.samples_per_metre, 0.5 * height / std::abs(camera.y_mag));
    } else {
        hints.eyes.push_back({origin + dvec3(view.position), height / static_cast<double>(camera.y_fov)});
    }
}

void add_light_maps(DetailHints& hints, const LightMaps& maps, const dvec3& origin) {
    for (const LightData& light : maps.light_data()) {
        if (light.layers == 0 || light.shares_map != 0) {
            continue;
        }
        const dvec3 at = origin + dvec3(light.position);
        const int resolution = light.type == kLightAreaSample ? maps.area_resolution() : maps.resolution();
        if (light.type == kLightDirectional) {
            hints.samples_per_metre = std::max(hints.samples_per_metre, 0.5 * resolution / light.extent);
        } else if (light.layers == 6) {
            hints.eyes.push_back({at, cube_samples_per_radian(resolution)});
        } else {
            hints.eyes.push_back({at, 0.5 * resolution / std::atan(static_cast<double>(light.extent))});
        }
    }
}

}  // namespace lanthorn::render
