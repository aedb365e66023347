// Indirect light on light sensors: the photons that have landed on their discs.
#pragma once

#include <vector>

#include "engine/render/light_sensors.h"
#include "gi_module/techniques/emc/photons/photon_set.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

class SensorPhotons {
  public:
    // Adds their flux over the disc's area to each sensor's irradiance. Every photon counts that landed
    // within the disc, on a surface that looks about the same way and less than a fifth of the disc's radius
    // off its plane: its relative noise is that of their number. Cost: one look at every photon a sensor.
    void add(const PhotonSet& photons, const render::SensorTargets& targets);
    // The same of photons that are not on the GPU: it is sent all of them, 32 bytes each.
    void add(const std::vector<PhotonHit>& photons, const render::SensorTargets& targets);

  private:
    gpu::Program program_;
    PhotonSet sent_;
    gpu::BufferTexture hits_;
};

}  // namespace lanthorn::gi
