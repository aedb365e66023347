#include "gi_module/techniques/drm/sample_pictures.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::gi {

namespace {

constexpr float kLift = 0.02f;  // of a sample's width, off its surface: the map's texels are not exact

// Reflected lumen over pi, whatever the solid angle has made of RadianceSample::sent.
vec3 lumen_over_pi(const RadianceSample& s, SolidAngle kind, float diagonal, int cells) {
    switch (kind) {
        case SolidAngle::eq_15:
            return s.across > 0 ? s.sent * (diagonal * diagonal * s.area / s.across) : vec3(0);
        case SolidAngle::eq_11:
            return s.sent * (s.area * static_cast<float>(cells) / (2 * kPi));
        case SolidAngle::eq_14:
        case SolidAngle::disc:
        case SolidAngle::eq_13:
            break;
    }
    return s.sent;
}

render::LightData light_of(const RadianceSample& s, const vec3& sent) {
    render::LightData light{};
    light.type = render::kLightAreaSample;
    light.direction = s.normal;
    light.position = s.place + s.normal * (kLift * std::sqrt(s.area));
    light.range = 1e30f;
    light.intensity = sent;
    light.area = 1;
    const vec3 helper = std::abs(s.normal.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0);
    light.right = glm::normalize(glm::cross(s.normal, helper));
    light.up = glm::cross(light.right, s.normal);
    light.cos_outer = -1;
    light.layers = 6;
    return light;
}

}  // namespace

LightPictures pictures_of_samples(std::vector<RadianceSample>& samples, SolidAngle kind, float diagonal,
                                  int cells) {
    std::vector<vec3> sent;
    for (RadianceSample& s : samples) {
        s.picture = -1;
        sent.push_back(lumen_over_pi(s, kind, diagonal, cells));
    }
    const auto brightness = [&](std::size_t i) { return sent[i].r + sent[i].g + sent[i].b; };
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples[i].normal != vec3(0) && brightness(i) > 0 && std::isfinite(brightness(i))) {
            order.push_back(i);
        }
    }
    LightPictures result;
    if (order.size() > static_cast<std::size_t>(kMostSamplePictures)) {
        result.left_out = static_cast<int>(order.size()) - kMostSamplePictures;
        std::ranges::stable_sort(order, std::ranges::greater{}, brightness);
        order.resize(kMostSamplePictures);
        std::ranges::sort(order);
    }
    for (const std::size_t i : order) {
        render::LightData light = light_of(samples[i], sent[i]);
        light.first_layer = 6 * static_cast<std::uint32_t>(result.lights.size());
        samples[i].picture = static_cast<std::int32_t>(light.first_layer);
        result.lights.push_back(light);
        LightPicture shape{};
        shape.shape = kPictureHemisphere;
        shape.drawn_here = 1;
        result.shapes.push_back(shape);
    }
    return result;
}

}  // namespace lanthorn::gi
