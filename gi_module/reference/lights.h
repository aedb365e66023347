// Punctual lights as the path tracer draws from them: engine/render/lights.glsl on the CPU.
#pragma once

#include <vector>

#include "engine/scene/frame_scene.h"

namespace lanthorn::reference {

struct PunctualLight {
    LightType type = LightType::point;
    vec3 position{0};
    vec3 direction{0, 0, -1};  // unit, the way it shines
    vec3 intensity{0};         // candela, or lux (directional)
    float range = 1e30f;       // metres
    float cone_scale = 0;
    float cone_offset = 1;
    float weight = 0;      // 1 / probability of being drawn
    float cumulative = 0;  // of this one or one before it
};

// What a light gives at a point, shadow not regarded.
struct LightSample {
    vec3 illuminance{0};  // lux on a surface square to the light
    vec3 to_light{0};     // unit
    bool infinite = false;
};

class PunctualLights {
  public:
    explicit PunctualLights(const FrameScene& scene);

    bool empty() const { return lights_.empty(); }
    bool several() const { return lights_.size() > 1; }
    // One of them, half by flux and half evenly; u in [0, 1). There must be one. O(log n).
    const PunctualLight& draw(float u) const;

    static LightSample illuminance(const PunctualLight& light, const vec3& point);

  private:
    std::vector<PunctualLight> lights_;
};

}  // namespace lanthorn::reference
