// Light sensors under techniques that keep photons: points of each disc's surface, at which the technique
// estimates what it estimates anywhere else.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/light_sensors.h"
#include "gi_module/reference/trace_scene.h"
#include "lanthorn/gpu/growing_buffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

// A point of the surface that a sensor's disc lies on.
struct SensorPoint {
    vec3 position{0};  // render space, on the triangle
    vec3 normal{0};    // of the triangle, unit, on the side that the sensor looks to
    std::uint32_t instance = 0;
    std::uint32_t primitive = 0;
    bool front = false;
    std::uint32_t sensor = 0;
};

// So many points of a disc are looked at, evenly over it.
inline constexpr int kSensorPoints = 16;

// Those of kSensorPoints a disc under which there is a surface: within a fifth of the disc's radius of its
// plane, turned away from it by 60 degrees at most. Sensor after sensor. A ray each.
std::vector<SensorPoint> sensor_points(const reference::TraceScene& scene,
                                       std::span<const SensorInstance> sensors);

class SensorLight {
  public:
    // Adds to every sensor the mean of its points' irradiances, in lux; to one without any point nothing.
    void add(std::span<const SensorPoint> points, std::span<const vec4> irradiances,
             const render::SensorTargets& targets);

  private:
    gpu::Program program_;
    gpu::GrowingBuffer light_;
};

}  // namespace lanthorn::gi
