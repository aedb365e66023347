// Adds the parts of light up, exposes, tone maps and encodes for display: stages in the order in which they
// stand here, each of which is given what it reads besides the picture so far.
#pragma once

#include <cstdint>
#include <memory>

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/brdf_table.h"
#include "lanthorn/render/camera_uniforms.h"
#include "lanthorn/render/gbuffer.h"
#include "lanthorn/render/render_settings.h"
#include "lanthorn/render/sky_texture.h"

namespace lanthorn::render {

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
    // What the picture is exposed for.
    struct Metering {
        bool reset = false;   // at once (first frame, cut) instead of gliding towards it
        bool around = false;  // the light around what it shows is measured as well, for Fuzzy
    };
    // The exposure that suits the radiance, or that `settings` ask for. O(1): a grid of points.
    void expose(const RenderSettings& settings, const Metering& metering);
    // The exposure of another picture, which has been exposed; after expose().
    void expose_as(const Composite& other);
    // The radiance spread over what is around, for DisplayInputs: RGBA32F, a texel for 4 x 4 pixels, until
    // the next call. `spread`: RenderSettings::bloom_spread. O(pixels).
    const gpu::Texture& scatter(float spread);

    // What the picture shows, where something of it has render.rim's fuzz.
    struct Fuzzy {
        const GBuffer& gbuffer;
        const CameraUniforms& camera;
    };
    // What is laid over the radiance as it is displayed; null: nothing.
    struct DisplayInputs {
        const gpu::Texture* scattered = nullptr;  // of scatter(): RenderSettings::bloom_share of the light
        const Fuzzy* fuzzy = nullptr;             // RenderSettings::rim; exposed with Metering::around
    };
    // Exposure, tone map and sRGB of the radiance into final(); radiance() stays as it was. O(pixels).
    void display(const RenderSettings& settings, const DisplayInputs& inputs);
    // Smooths edges in final(). O(pixels).
    void smooth();

    const gpu::Texture& radiance() const { return radiance_; }  // RGBA32F, nits, before exposure
    const gpu::Texture& final() const { return final_; }        // RGBA8, sRGB-encoded
    const gpu::Texture& unsmoothed() const;                     // the same before smooth()
    // Draws into radiance().
    const gpu::Framebuffer& radiance_framebuffer() const { return radiance_framebuffer_; }
    const gpu::Framebuffer& final_framebuffer() const { return final_framebuffer_; }  // draws into final()
    const BrdfTable& brdf_table() const { return brdf_table_; }  // what combine() reflects even light by
    float exposure() const;           // waits for the GPU: factor from nits to display-linear
    std::uint32_t nan_count() const;  // waits for the GPU: pixels replaced since construction

  private:
    struct Stages;

    ivec2 size_;
    gpu::Texture radiance_;
    gpu::Texture final_;
    gpu::Framebuffer radiance_framebuffer_;
    gpu::Framebuffer final_framebuffer_;
    gpu::Buffer state_;  // composite_state.glsl
    BrdfTable brdf_table_;
    std::unique_ptr<Stages> stages_;
    bool smoothed_ = false;  // since display()
};

}  // namespace lanthorn::render
