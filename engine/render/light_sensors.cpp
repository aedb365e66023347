#include "engine/render/light_sensors.h"

#include <cstring>
#include <utility>

#include "engine/core/finite.h"

namespace lanthorn::render {

bool LightSensors::wants(const FrameScene& scene, const LightMaps& light_maps,
                         std::uint64_t indirect_version) {
    wanted_ = {scene.sensors, light_maps.version(), indirect_version};
    ++since_;
    return !scene.sensors.empty() && since_ >= kInterval && !read_back_.full() && wanted_ != measured_;
}

SensorTargets LightSensors::measure_direct(const FrameScene& scene, const LightMaps& light_maps) {
    std::vector<SensorData> data;
    for (const SensorInstance& sensor : scene.sensors) {
        data.push_back({sensor.position, sensor.radius, sensor.direction, 0});
    }
    if (sensors_.bytes() < data.size() * sizeof(SensorData)) {
        sensors_ = gpu::Buffer(data.size() * sizeof(SensorData));
        irradiances_ = gpu::Buffer(data.size() * sizeof(vec4));
    }
    sensors_.write(0, std::span<const SensorData>(data));
    irradiances_.clear();
    if (light_maps.light_count() > 0) {
        const gpu::Program& program = programs_.bind(light_maps, 0);
        sensors_.bind_storage(kSensorsBinding);
        irradiances_.bind_storage(kSensorIrradianceBinding);
        program.use();
        glDispatchCompute(static_cast<GLuint>(data.size()), 1, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    return {sensors_, irradiances_, static_cast<int>(data.size())};
}

void LightSensors::send(std::uint64_t step) {
    under_way_.push_back(wanted_.sensors);
    read_back_.begin(irradiances_, wanted_.sensors.size() * sizeof(vec4), step);
    measured_ = wanted_;
    since_ = 0;
}

std::vector<SensorLight> LightSensors::take() {
    std::vector<SensorLight> samples;
    while (const auto arrived = read_back_.take()) {
        add_samples(*arrived, samples);
    }
    return samples;
}

std::vector<SensorLight> LightSensors::finish() {
    std::vector<SensorLight> samples;
    while (const auto arrived = read_back_.wait()) {
        add_samples(*arrived, samples);
    }
    return samples;
}

void LightSensors::add_samples(const gpu::ReadBack::Arrived& arrived, std::vector<SensorLight>& samples) {
    const std::vector<SensorInstance> sensors = std::move(under_way_.front());
    under_way_.erase(under_way_.begin());
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        vec4 irradiance;
        std::memcpy(&irradiance, arrived.bytes.data() + i * sizeof irradiance, sizeof irradiance);
        const vec3 illuminance(irradiance);
        if (is_finite(illuminance)) {
            samples.push_back({sensors[i].id, arrived.tag, illuminance, sensors[i].reading(illuminance)});
        }
    }
}

}  // namespace lanthorn::render
