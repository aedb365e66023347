// Adds the parts of light up, exposes, tone maps and encodes for display.
#pragma once

#include <cstdint>
#include <memory>

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/pass_timer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/program_variants.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/brdf_table.h"
#include "lanthorn/render/camera_uniforms.h"
#include "lanthorn/render/gbuffer.h"
#include "lanthorn/render/render_settings.h"
#include "lanthorn/render/sky_texture.h"

namespace lanthorn::render {

class Bloom;
class Fxaa;

class Composite {
  public:
    // `depth`: the G-buffer's, for what is drawn onto radiance_framebuffer() in between.
    Composite(ivec2 size, const gpu::Texture& depth);
    ~Composite();

    // What the picture is put together from, one texel a pixel.
    struct Parts {
        const gpu::Texture* direct = nullptr;               // radiance, nits
        const gpu::Texture* indirect_irradiance = nullptr;  // lux; null: none
        const gpu::Texture* indirect_specular = nullptr;    // IndirectLight::specular; null: none
    };
    // radiance = direct + emissive + specular + irradiance / pi * occlusion * (what of even light is
    // reflected: diffusely, and by the share of the specular lobe that `specular` does not have); where there
    // is no surface, the sky's. A value that is NaN or infinite becomes 0 and is counted.
    void combine(const GBuffer& gbuffer, const Parts& parts, const SkyTexture& sky,
                 const CameraUniforms& camera, PixelStage stage = PixelStage::fragment);
    // The radiance is that of a texture of the same size and format.
    void take(const gpu::Texture& radiance);
    // What the picture shows, where something of it has render.rim's fuzz.
    struct Fuzzy {
        const GBuffer& gbuffer;
        const CameraUniforms& camera;
    };
    // How display() differs from that of a picture by itself.
    struct Shown {
        const Fuzzy* fuzzy;        // null: nothing has fuzz
        const Composite* exposed;  // with its exposure: it has been displayed; null: with what suits this one
    };
    // Exposure, tone map and sRGB of the radiance into final(), bright light scattered and edges smoothed if
    // settings say so; radiance() stays as it was.
    // `reset_exposure`: take the measured exposure at once (first frame, cut) instead of gliding towards it.
    // The scattering is timed as [bloom] where there is a timer.
    void display(const RenderSettings& settings, bool reset_exposure, gpu::PassTimer* timer = nullptr,
                 const Shown& as = {});

    const gpu::Texture& radiance() const { return radiance_; }  // RGBA32F, nits, before exposure
    const gpu::Texture& final() const { return final_; }        // RGBA8, sRGB-encoded
    const gpu::Texture& unsmoothed() const;                     // the same before edges were smoothed
    // Draws into radiance().
    const gpu::Framebuffer& radiance_framebuffer() const { return radiance_framebuffer_; }
    const gpu::Framebuffer& final_framebuffer() const { return final_framebuffer_; }  // draws into final()
    const BrdfTable& brdf_table() const { return brdf_table_; }  // what combine() reflects even light by
    float exposure() const;           // waits for the GPU: factor from nits to display-linear
    std::uint32_t nan_count() const;  // waits for the GPU: pixels replaced since construction

  private:
    // `around`: what rims need is measured as well.
    void expose(const RenderSettings& settings, bool reset, bool around);

    ivec2 size_;
    gpu::Texture radiance_;
    gpu::Texture final_;
    gpu::Framebuffer radiance_framebuffer_;
    gpu::Framebuffer final_framebuffer_;
    gpu::Buffer state_;  // composite_state.glsl
    BrdfTable brdf_table_;
    gpu::ProgramVariants combine_{{"engine/render/fullscreen.vert", "engine/render/combine.frag"}};
    gpu::ProgramVariants compute_combine_{{"engine/render/combine.comp"}};
    gpu::ProgramVariants expose_{{"engine/render/expose.comp"}};
    gpu::ProgramVariants display_{{"engine/render/fullscreen.vert", "engine/render/display.frag"}};
    gpu::ProgramVariants compute_display_{{"engine/render/display.comp"}};
    std::unique_ptr<Bloom> bloom_;  // these once asked for
    std::unique_ptr<Fxaa> fxaa_;
    bool smoothed_ = false;  // by the last display()
};

}  // namespace lanthorn::render
