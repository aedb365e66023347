// The light that falls on the scene's light sensors, computed on the GPU and read back without waiting for
// it.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/gpu/read_back.h"
#include "engine/render/sensor_data.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/render/light_maps.h"
#include "lanthorn/render/light_programs.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::render {

// The sensors of a frame on the GPU: what a technique adds its indirect light to.
struct SensorTargets {
    const gpu::Buffer& sensors;      // SensorData
    const gpu::Buffer& irradiances;  // vec4: rgb in lux
    int count = 0;
};

// What falls on a sensor's disc.
struct SensorLight {
    std::uint32_t id = 0;    // the entity's index
    std::uint64_t step = 0;  // of the state that was looked at (Time::steps)
    vec3 illuminance{0};     // lux, by channel
    float reading = 0;       // lux, through the filter that the sensor had then
};

//   if (sensors.wants(scene, light_maps, technique_version)) {
//       technique.add_irradiance(light_inputs, sensors.measure_direct(scene, light_maps));
//       sensors.send(step);
//   }
//   for (const SensorLight& light : sensors.take()) { ... }   // of earlier frames
class LightSensors {
  public:
    // Whether there is anything to measure now: sensors, light maps or `indirect_version` (what the indirect
    // light is computed from) are not those of the last measurement, that was kInterval frames ago or more,
    // and fewer measurements are under way than fit. Call once a frame, after the light maps are drawn.
    bool wants(const FrameScene& scene, const LightMaps& light_maps, std::uint64_t indirect_version);

    // Direct light on every sensor. Cost: 64 shadow look-ups a sensor and light.
    SensorTargets measure_direct(const FrameScene& scene, const LightMaps& light_maps);
    // What is in the targets now goes on its way; `step`: of the state that the frame shows.
    void send(std::uint64_t step);

    // What has come back since the last call, oldest first; values that are not finite are left out. Never
    // waits.
    std::vector<SensorLight> take();
    // The same, but waits for all that is under way.
    std::vector<SensorLight> finish();

    static constexpr int kInterval = 4;  // frames

  private:
    struct Measured {
        std::vector<SensorInstance> sensors;
        std::uint64_t light_maps = 0, indirect = 0;
        bool operator==(const Measured&) const = default;
    };
    void add_samples(const gpu::ReadBack::Arrived& arrived, std::vector<SensorLight>& samples);

    LightPrograms programs_{{"engine/render/sensor_direct.comp"}};
    gpu::Buffer sensors_, irradiances_;
    gpu::ReadBack read_back_;
    std::vector<std::vector<SensorInstance>> under_way_;  // what was sent to be measured, oldest first
    Measured wanted_, measured_;
    int since_ = kInterval;  // frames since the last measurement
};

}  // namespace lanthorn::render
