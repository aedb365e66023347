#include "lanthorn/render/shining_lights.h"

#include <algorithm>
#include <iterator>

namespace lanthorn::render {

namespace {

LightKind kind_of(const LightData& light) {
    if (light.type == kLightAreaSample) {
        return LightKind::area;
    }
    if (light.type == kLightDirectional && light.layers == 1) {
        return LightKind::directional;
    }
    if (light.type == kLightPoint && light.layers == 6) {
        return LightKind::point;
    }
    return light.type == kLightSpot && light.layers == 1 ? LightKind::spot : LightKind::other;
}

}  // namespace

bool ShiningLights::has(LightKind kind) const {
    const auto k = static_cast<std::size_t>(kind);
    return ends[k] > (k == 0 ? 0 : ends[k - 1]);
}

ShiningLights shining_lights(std::span<const LightData> lights) {
    ShiningLights shining;
    for (std::size_t k = 0; k < kLightKinds; ++k) {
        const auto of_kind = [k](const LightData& light) {
            return static_cast<std::size_t>(kind_of(light)) == k;
        };
        const std::size_t begin = shining.lights.size();
        std::ranges::copy_if(lights, std::back_inserter(shining.lights), [&](const LightData& light) {
            return of_kind(light) && light.intensity != vec3(0);
        });
        const auto first = std::ranges::find_if(lights, of_kind);
        if (shining.lights.size() == begin && first != lights.end()) {
            shining.lights.push_back(*first);
        }
        shining.ends[k] = static_cast<int>(shining.lights.size());
    }
    return shining;
}

}  // namespace lanthorn::render
