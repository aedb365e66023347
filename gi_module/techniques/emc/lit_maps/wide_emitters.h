// Emissive surfaces of whose light a few points are no measure: those that are merged or have no area
// samples, and those that are wide beside the room. Photons bring their direct light to the lit maps.
#pragma once

#include <cstdint>
#include <vector>

#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class WideEmitters {
  public:
    // Which there are. Whether the lights that are left for direct light are others than before. Cost: a
    // look at each emissive triangle.
    bool follow(const render::LightInputs& inputs, const EnvironmentMaps& maps);
    // There are none.
    bool clear();

    bool any() const { return any_; }
    // Some have area samples, which direct light on the lit maps leaves out.
    bool sampled() const { return !ids_.empty(); }
    // By emissive triangle, uint: whether it is one of theirs.
    const gpu::Buffer& triangles() const { return triangles_; }
    // LightMaps::shining_buffer() without their area samples, to be bound in its place.
    void bind_other_lights(const render::LightMaps& light_maps);

  private:
    std::vector<std::uint32_t> ids_;    // instances of theirs that have area samples
    std::vector<std::uint32_t> flags_;  // triangles_
    bool any_ = false;
    gpu::Buffer triangles_;
    gpu::Buffer lights_;
};

}  // namespace lanthorn::gi
