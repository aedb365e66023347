// Punctual lights as the path tracer draws from them: engine/render/lights.glsl on the CPU.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::reference {

struct PunctualLight {
    LightType type = LightType::point;
    vec3 position{0};
    vec3 direction{0, 0, -1};  // unit, the way it shines
    vec3 intensity{0};         // candela, or lux (directional)
    float range = 1e30f;       // metres
    float cone_scale = 0;
    float cone_offset = 1;
    float weight = 0;         // 1 / probability of being drawn
    float cumulative = 0;     // of this one or one before it
    std::uint32_t index = 0;  // into FrameScene::lights
};

// What a light gives at a point, shadow not regarded.
struct LightSample {
    vec3 illuminance{0};  // lux on a surface square to the light
    vec3 to_light{0};     // unit
    bool infinite = false;
};

// Illuminance by a point or spot light, `to_light` set; a point light's cone is 1 in every direction.
inline vec3 local_illuminance(const PunctualLight& light, const vec3& point, vec3& to_light) {
    const vec3 span = light.position - point;
    const float r2 = std::max(glm::dot(span, span), 1e-30f);
    const float inverse = 1 / std::sqrt(r2);
    to_light = span * inverse;
    // KHR_lights_punctual's window: 1 near the light, 0 from `range` on.
    const float s = light.range >= 1e30f ? 0.0f : r2 * inverse / light.range;
    const float window = glm::clamp(1 - s * s * s * s, 0.0f, 1.0f);
    const float cosine = -glm::dot(to_light, light.direction);
    const float cone = glm::clamp(cosine * light.cone_scale + light.cone_offset, 0.0f, 1.0f);
    const float share = window * inverse * inverse * (cone * cone);
    return light.intensity * share;
}

class PunctualLights {
  public:
    explicit PunctualLights(const FrameScene& scene);

    bool empty() const { return lights_.empty(); }
    const std::vector<PunctualLight>& all() const { return lights_; }  // those that give light
    bool several() const { return lights_.size() > 1; }
    // One of them, half by flux and half evenly; u in [0, 1). There must be one. O(log n).
    const PunctualLight& draw(float u) const;

    static LightSample illuminance(const PunctualLight& light, const vec3& point);

  private:
    std::vector<PunctualLight> lights_;
};

}  // namespace lanthorn::reference
