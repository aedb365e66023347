// A frame, from a FrameScene to a picture: its passes, one function each. Whoever shows a scene runs them as
// systems (engine/runtime/include/lanthorn/runtime/render_plugin.h), with those of the indirect light between
// them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "lanthorn/core/image.h"
#include "lanthorn/gpu/pass_timer.h"
#include "lanthorn/render/camera_uniforms.h"
#include "lanthorn/render/composite.h"
#include "lanthorn/render/emissive.h"
#include "lanthorn/render/gbuffer.h"
#include "lanthorn/render/gpu_scene.h"
#include "lanthorn/render/light_maps.h"
#include "lanthorn/render/lines.h"
#include "lanthorn/render/render_settings.h"
#include "lanthorn/render/sky_texture.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::render {

// What is known before the camera has looked: what photons and maps are made from.
struct LightInputs {
    const FrameScene& scene;
    const GpuScene& gpu_scene;
    const LightMaps& light_maps;
    const EmissiveTriangles& emissive;
    const SkyTexture& sky;
    gpu::PassTimer& timer;
};

// The same with what the camera sees: what indirect light in the picture is computed from.
struct FrameInputs : LightInputs {
    const GBuffer& gbuffer;
    CameraUniforms camera;
    const GBuffer* blended = nullptr;  // the nearest blended surfaces before it; null: none is in view
};

// Textures of the G-buffer's size, owned by the technique; null where it gives none.
struct IndirectLight {
    const gpu::Texture* irradiance = nullptr;  // RGBA32F, lux
    // RGBA32F: radiance that is reflected specularly or goes through, nits; a: the share of the specular lobe
    // that it has. The rest is lit by irradiance, as if light came evenly.
    const gpu::Texture* specular = nullptr;
    // RGBA32F, nits: all that the picture shows, direct light and what is see-through included, in place of
    // what would be composed; a: 0 background, 1 lit, 2 unlit.
    const gpu::Texture* radiance = nullptr;
    // RGBA32F, lux: on the surfaces of FrameInputs::blended. Without it what is blended is lit by what falls
    // on what lies behind.
    const gpu::Texture* blended_irradiance = nullptr;
    // RGBA32F, lux, straight from lamps: what direct light is made from where TracedLobes::lamps is true.
    const gpu::Texture* lamps = nullptr;
};

// What of the specular lobes indirect light traces, in which area lights are then met as what emits: direct
// light has of their highlights what few rays would meet (traced_lobes.glsl).
struct TracedLobes {
    float roughness = 0;  // of the roughest surface; over the 0.15 below it they go over. 0: none
    // Indirect light brings what lamps send as well (IndirectLight::lamps): the direct pass is left out, and
    // surfaces reflect that light as if it came evenly. What is see-through is lit by the light maps still.
    bool lamps = false;
};

// What read() takes out of a frame, for files and for comparison.
enum class Aov {
    final,     // RGB, tone mapped and sRGB-encoded, 0..1
    radiance,  // RGB, nits: what `final` shows before exposure
    direct,    // RGB, nits
    indirect,  // RGB, lux: irradiance, albedo not applied
    albedo,    // RGB, linear: diffuse albedo
    normal,    // XYZ, render space: shading normal
    depth,     // one channel, metres from the camera's position; 0: background
};

class SceneRenderer;

// A view's part of the frame: G-buffer, direct light, picture. What all views of a scene share (the scene on
// the GPU, light maps) is in a SceneRenderer, which renderers of several views have in common.
class FrameRenderer {
  public:
    // With a scene of its own, or with one that is shared: who shares it calls its passes once a frame
    // instead of begin() and draw_light_maps().
    FrameRenderer();
    explicit FrameRenderer(std::shared_ptr<SceneRenderer> shared);
    ~FrameRenderer();

    RenderSettings settings;  // may be altered between frames

    // The passes of a frame of `size` pixels, to be called in this order; indirect light is made from
    // inputs() after draw_gbuffer(). Each is timed under the name in brackets. What neither the view nor a
    // change of the scene since this renderer's last frame alters is kept, not drawn. The first frame, and
    // the first after a change of size, takes its exposure at once. `whole`: of the picture that upscale()
    // makes of it; 0, or fewer pixels: none, as where settings say so.
    void begin(const FrameScene& scene, ivec2 size, gpu::PassTimer& timer,
               ivec2 whole = ivec2(0));                                    // [upload] what differs
    void draw_light_maps(const FrameScene& scene, gpu::PassTimer& timer);  // [light_maps]
    void draw_gbuffer(const FrameScene& scene, gpu::PassTimer& timer);     // [gbuffer]
    void draw_direct(const FrameScene& scene, const TracedLobes& traced,
                     gpu::PassTimer& timer);  // [direct]; nothing where compose() will be given it
    // [composite], and in it [air] and [bloom] where they are on. `exposed_as`: a renderer whose picture of
    // this frame is composed; this one's has the same exposure.
    void compose(const FrameScene& scene, const IndirectLight& indirect, gpu::PassTimer& timer,
                 const FrameRenderer* exposed_as = nullptr);

    // Over the picture, after compose(): both lists. Costs nothing for none. [lines]
    void draw_lines(const FrameScene& scene, std::span<const Line> some, std::span<const Line> more,
                    gpu::PassTimer& timer);

    // After the lines: the whole picture, of more pixels than are drawn, if there is one. [upscale]
    void upscale(const FrameScene& scene, gpu::PassTimer& timer);

    // begin() without what is shared.
    void resize(ivec2 size, ivec2 whole = ivec2(0));
    // What the next frame shows has nothing to do with what the last one did, however alike it looks.
    void restart();

    // Valid until the next begin(); light_inputs() once the light maps are drawn, inputs() once the G-buffer
    // is.
    LightInputs light_inputs(const FrameScene& scene, gpu::PassTimer& timer) const;
    // What techniques of indirect light are made from: light_inputs(), the G-buffer and the camera.
    FrameInputs inputs(const FrameScene& scene, gpu::PassTimer& timer) const;

    ivec2 size() const;        // drawn pixels; 0 before the first frame
    ivec2 final_size() const;  // pixels of final()

    // Of the last frame; at least one must have been rendered. Reading back waits for the GPU.
    const gpu::Texture& final()
        const;  // RGBA8, sRGB-encoded, rows upwards; the whole picture, if there is one
    // RGBA16F, what the next upscale() starts from; there must be a whole picture.
    const gpu::Texture& upscaled_history() const;
    // Copies final() into a framebuffer (0: the window), to the rectangle of `size` pixels whose lower left
    // corner is at `corner`.
    void present(GLuint framebuffer, ivec2 size, ivec2 corner = ivec2(0)) const;
    // In the form that Aov says, rows from the top.
    ImageF read(Aov aov) const;
    std::uint32_t nan_count() const;      // of the radiance, replaced by black since the picture got its size
    float exposure() const;               // factor from nits to display-linear
    const GpuScene& gpu_scene() const;    // as the last begin() uploaded it; shared by views
    const LightMaps& light_maps() const;  // of this view's settings; shared with views that ask the same
    const EmissiveTriangles& emissive() const;  // of the scene; shared by views
    const GBuffer& gbuffer() const;             // of this view

  private:
    friend class SceneRenderer;
    struct Targets;
    std::shared_ptr<SceneRenderer> shared_;
    std::shared_ptr<LightMaps> light_maps_;  // of shared_, for these settings; null before they are drawn
    std::unique_ptr<Targets> targets_;
    bool cut_ = true;                   // the first frame of its size
    std::uint64_t upscaled_ = 0;        // frames since upscale() had its sizes
    std::optional<CameraView> looked_;  // by the last upscale()
    IndirectLight indirect_;

    void draw_blended_surfaces(const CameraUniforms& camera);
    // What compose() ends with: from the radiance to the picture.
    void show(const FrameScene& scene, gpu::PassTimer& timer, const FrameRenderer* exposed_as);
    CameraUniforms camera(const FrameScene& scene) const;
    CameraUniforms through_middles(const FrameScene& scene) const;
    bool upscales() const;
    bool shows_the_same_surfaces(const FrameScene& scene) const;
};

}  // namespace lanthorn::render
