#include "gi_module/reference/lights.h"

#include <algorithm>
#include <cmath>

#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

namespace {

PunctualLight describe(const LightInstance& instance) {
    const Light& light = instance.light;
    PunctualLight result;
    result.type = light.type;
    result.position = instance.position;
    result.direction = instance.direction;
    result.intensity = light.colour * light.intensity;
    result.range = std::min(light.range, 1e30f);
    if (light.type == LightType::spot) {
        const float cos_outer = std::cos(light.outer_cone);
        result.cone_scale = 1 / std::max(1e-3f, std::cos(light.inner_cone) - cos_outer);
        result.cone_offset = -cos_outer * result.cone_scale;
    }
    return result;
}

// Lumen, roughly: what it is drawn by.
double flux(const LightInstance& instance, double diagonal) {
    const double pi = static_cast<double>(kPi);
    const double strength =
        static_cast<double>(luminance(instance.light.colour)) * static_cast<double>(instance.light.intensity);
    switch (instance.light.type) {
        case LightType::directional:
            return strength * pi * 0.25 * diagonal * diagonal;
        case LightType::spot:
            return strength * 2 * pi * (1 - std::cos(static_cast<double>(instance.light.outer_cone)));
        case LightType::point:
            break;
    }
    return strength * 4 * pi;
}

}  // namespace

PunctualLights::PunctualLights(const FrameScene& scene) {
    std::vector<double> weights;
    double total = 0;
    for (const LightInstance& instance : scene.lights) {
        const double weight = flux(instance, static_cast<double>(scene.diagonal()));
        if (weight > 0) {
            lights_.push_back(describe(instance));
            lights_.back().index = static_cast<std::uint32_t>(&instance - scene.lights.data());
            weights.push_back(weight);
            total += weight;
        }
    }
    double sum = 0;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const double p = 0.5 * weights[i] / total + 0.5 / static_cast<double>(lights_.size());
        sum += p;
        lights_[i].weight = static_cast<float>(1 / p);
        lights_[i].cumulative = static_cast<float>(sum);
    }
}

const PunctualLight& PunctualLights::draw(float u) const {
    const auto found = std::ranges::upper_bound(lights_, u, {}, &PunctualLight::cumulative);
    return found == lights_.end() ? lights_.back() : *found;
}

LightSample PunctualLights::illuminance(const PunctualLight& light, const vec3& point) {
    if (light.type == LightType::directional) {
        return {light.intensity, -light.direction, true};
    }
    LightSample sample;
    sample.illuminance = local_illuminance(light, point, sample.to_light);
    return sample;
}

}  // namespace lanthorn::reference
