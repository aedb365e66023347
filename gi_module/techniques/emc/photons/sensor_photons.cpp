#include "gi_module/techniques/emc/photons/sensor_photons.h"

#include <bit>
#include <cstdint>
#include <span>

namespace lanthorn::gi {

namespace {

constexpr float kLayer = 0.2f;  // of a disc's radius

}  // namespace

void SensorPhotons::add(const PhotonSet& photons, const render::SensorTargets& targets) {
    if (photons.capacity == 0) {
        return;
    }
    if (!program_) {
        program_ = gpu::Program({"gi_module/techniques/emc/photons/sensor_photons.comp"});
    }
    program_.use();
    hits_.bind(0, photons.hits, GL_RGBA32F);
    program_.set("photon_hits", 0);
    program_.set("layer", kLayer);
    photons.count.bind_storage(2);
    targets.sensors.bind_storage(render::kSensorsBinding);
    targets.irradiances.bind_storage(render::kSensorIrradianceBinding);
    glDispatchCompute(static_cast<GLuint>(targets.count), 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void SensorPhotons::add(const std::vector<PhotonHit>& photons, const render::SensorTargets& targets) {
    if (photons.empty()) {
        return;
    }
    if (sent_.capacity < static_cast<int>(photons.size())) {
        sent_.allocate(static_cast<int>(std::bit_ceil(photons.size())));
    }
    const auto count = static_cast<std::uint32_t>(photons.size());
    sent_.hits.write(0, std::span<const PhotonHit>(photons));
    sent_.count.write(0, std::span<const std::uint32_t>(&count, 1));
    add(sent_, targets);
}

}  // namespace lanthorn::gi
