// Light that arrives straight from the light sources: one pass over the G-buffer.
#pragma once

#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/brdf_table.h"
#include "lanthorn/render/camera_uniforms.h"
#include "lanthorn/render/gbuffer.h"
#include "lanthorn/render/light_maps.h"
#include "lanthorn/render/light_programs.h"
#include "lanthorn/render/render_settings.h"

namespace lanthorn::render {

class DirectLight {
  public:
    explicit DirectLight(ivec2 size);

    // Reflected radiance of all lights, shadowed; metallic-roughness GGX (brdf.glsl). `traced_roughness`:
    // TracedLobes.
    void draw(const GBuffer& gbuffer, const LightMaps& light_maps, const CameraUniforms& camera,
              float traced_roughness, PixelStage stage);
    // What surfaces reflect of `irradiance` (lux, RGBA32F of the same size), which comes as if evenly: in
    // place of draw(). Reads no light maps.
    void take(const GBuffer& gbuffer, const gpu::Texture& irradiance, const BrdfTable& table,
              const CameraUniforms& camera);

    // RGBA32F, nits; 0 where nothing is seen.
    const gpu::Texture& radiance() const { return radiance_; }

  private:
    ivec2 size_;
    gpu::Texture radiance_;
    gpu::Framebuffer framebuffer_;
    LightPrograms programs_, compute_programs_;
    gpu::Program take_program_;  // once asked for
};

}  // namespace lanthorn::render
