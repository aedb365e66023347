// A picture of more pixels than are drawn. Each frame looks through other places of its pixels, and what the
// frames before have seen is carried along with what moves, as temporal anti-aliasing does (Karis 2014,
// "High-quality temporal supersampling"; Yang et al. 2020, "A survey of temporal antialiasing techniques"):
// dropped where the frame before saw something else there (by distance and normal), limited to what the
// frame's own pixels bear (Salvi 2016), and made up for along the frame's edges where there is none.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/render/motion_pass.h"
#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/pass_timer.h"
#include "lanthorn/gpu/program_variants.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/camera_uniforms.h"
#include "lanthorn/render/gbuffer.h"
#include "lanthorn/render/render_settings.h"

namespace lanthorn::render {

class Upscaler {
  public:
    // From pictures of `drawn` pixels to those of `whole`, which has no fewer either way. 24 bytes a pixel of
    // both, and 64 a drawn one.
    Upscaler(ivec2 drawn, ivec2 whole);

    // What the frames before have left is of no use for the next.
    void restart() { before_.reset(); }
    // Pixels from their middles, -0.5..0.5, that frame `frame` looks through: Halton's sequence of bases 2
    // and 3 (Halton 1964), its first 8 numbers for each pixel of the whole picture in a drawn one.
    vec2 shift(std::uint64_t frame) const;

    // What a frame is made from.
    struct Frame {
        const gpu::Texture& picture;   // RGBA8, encoded for display
        const gpu::Texture& smoothed;  // the same with smooth edges
        const GBuffer& gbuffer;
        const GpuScene& scene;
        CameraUniforms camera;   // with its shift
        CameraUniforms through;  // the same, through the middles
        bool still = false;  // nothing but the shift differs from the frame before: no camera, thing or light
        bool cut = false;    // the scene is another
        dvec3 origin{0};     // FrameScene::origin; another one is a cut
    };
    // Fills whole(). History is dropped at a cut, and where the camera turns by more than 60 degrees or has
    // another angle of view. O(pixels of whole()).
    void add(const Frame& frame, const RenderSettings& settings);

    ivec2 size() const { return whole_; }
    const gpu::Texture& whole() const { return final_; }  // RGBA8, encoded for display
    const gpu::Framebuffer& framebuffer() const { return final_framebuffer_; }
    // RGBA16F: what the next frame starts from; a: samples.
    const gpu::Texture& history() const { return history_[latest_]; }

  private:
    void guide(const Frame& frame, bool moving);
    void resolve(const Frame& frame, bool with_history, bool moving);
    bool follows(const Frame& frame) const;

    ivec2 drawn_, whole_;
    gpu::Texture history_[2];
    gpu::Framebuffer history_framebuffers_[2];
    int latest_ = 0;
    gpu::Texture final_;
    gpu::Framebuffer final_framebuffer_;
    // By drawn pixel.
    gpu::Texture mean_, spread_, motion_, distance_before_, normals_before_;
    gpu::Framebuffer guide_framebuffer_, still_guide_framebuffer_;
    MotionPass movers_;
    std::optional<CameraUniforms> before_;  // the frame before looked through the middles; none: no history
    vec2 shift_before_{0};
    dvec3 origin_before_{0};
    gpu::ProgramVariants guide_{{"engine/render/fullscreen.vert", "engine/render/upscale_guide.frag"}};
    gpu::ProgramVariants resolve_{{"engine/render/fullscreen.vert", "engine/render/upscale_resolve.frag"}};
    gpu::Program sharpen_;
};

}  // namespace lanthorn::render
