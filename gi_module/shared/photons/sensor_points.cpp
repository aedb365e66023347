#include "gi_module/shared/photons/sensor_points.h"

#include <algorithm>
#include <cmath>

#include "gi_module/reference/sampling.h"

namespace lanthorn::gi {

namespace {

constexpr float kLayer = 0.2f;              // of a disc's radius: how far off its plane its surface may lie
constexpr float kLeastTurn = 0.5f;          // cosine between a disc's normal and its surface's
constexpr float kGoldenAngle = 2.3999632f;  // of points along a spiral, which lie evenly (Vogel 1979)

}  // namespace

std::vector<SensorPoint> sensor_points(const reference::TraceScene& scene,
                                       std::span<const SensorInstance> sensors) {
    std::vector<SensorPoint> points;
    for (std::uint32_t s = 0; s < sensors.size(); ++s) {
        const SensorInstance& sensor = sensors[s];
        const reference::Basis basis(sensor.direction);
        const float above = kLayer * sensor.radius;
        for (int i = 0; i < kSensorPoints; ++i) {
            const float along = std::sqrt((static_cast<float>(i) + 0.5f) / kSensorPoints) * sensor.radius;
            const float turn = static_cast<float>(i) * kGoldenAngle;
            const vec3 origin =
                sensor.position + basis.to_world({along * std::cos(turn), along * std::sin(turn), above});
            reference::SurfaceHit hit;
            if (scene.intersect(origin, -sensor.direction, 0, 2 * above, reference::Blended::ignored, hit,
                                reference::Sides::seen) &&
                glm::dot(hit.normal, sensor.direction) > kLeastTurn) {
                points.push_back({hit.position, hit.normal, hit.instance, hit.primitive, hit.front, s});
            }
        }
    }
    return points;
}

void SensorLight::add(std::span<const SensorPoint> points, std::span<const vec4> irradiances,
                      const render::SensorTargets& targets) {
    std::vector<vec4> sums(static_cast<std::size_t>(targets.count), vec4(0));
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].sensor < sums.size()) {
            sums[points[i].sensor] += vec4(vec3(irradiances[i]), 1);
        }
    }
    for (vec4& sum : sums) {
        sum /= std::max(sum.w, 1.0f);
    }
    if (!program_) {
        program_ = gpu::Program({"gi_module/shared/photons/sensor_light.comp"});
    }
    program_.use();
    light_.hold(std::span<const vec4>(sums)).bind_storage(2);
    targets.irradiances.bind_storage(render::kSensorIrradianceBinding);
    program_.set("sensor_count", targets.count);
    program_.dispatch(targets.count, 64);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace lanthorn::gi
