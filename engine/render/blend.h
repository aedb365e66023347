// Alpha-blended surfaces: a sorted forward pass over the lit picture.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/render/camera_uniforms.h"
#include "lanthorn/render/gbuffer.h"
#include "lanthorn/render/gpu_scene.h"
#include "lanthorn/render/light_maps.h"
#include "lanthorn/render/light_programs.h"

namespace lanthorn::render {

class BlendPass {
  public:
    // Indirect light by pixel: irradiance in lux, and the distances of the surfaces that it falls on
    // (GBuffer::distance()).
    struct Light {
        const gpu::Texture* behind = nullptr;  // on what is solid; null: there is none
        const gpu::Texture* distance_behind = nullptr;
        const gpu::Texture* nearest = nullptr;  // on the nearest that is blended; null: not known
        const gpu::Texture* distance_nearest = nullptr;
    };

    BlendPass();

    // Draws the blended instances over `target`'s colour (radiance, nits), farthest first by the centres of
    // their bounds, behind what `target`'s depth holds, but for their solid parts (alpha_coverage.h). Between
    // the nearest and what is solid indirect light goes from that of the one to that of the other by
    // distance. Costs nothing where the scene has none. The buffer of composite_state.glsl must be bound.
    void draw(const FrameScene& scene, const GpuScene& gpu_scene, const LightMaps& light_maps,
              const CameraUniforms& camera, const Light& light, const gpu::Framebuffer& target, ivec2 size);

  private:
    LightPrograms programs_;
    std::vector<std::uint32_t> order_;
};

}  // namespace lanthorn::render
