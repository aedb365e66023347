// What all views of a scene share in a frame: the scene on the GPU and the light maps.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/render/blend.h"
#include "engine/render/glow_pass.h"
#include "engine/render/line_pass.h"
#include "lanthorn/gpu/pass_timer.h"
#include "lanthorn/render/emissive.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/render/gpu_scene.h"
#include "lanthorn/render/light_maps.h"
#include "lanthorn/render/picture_only.h"
#include "lanthorn/render/sky_texture.h"

namespace lanthorn::render {

class SceneRenderer {
  public:
    // Timed as `upload`. Once a frame, before draw_light_maps().
    void update(const FrameScene& scene, gpu::PassTimer& timer);

    // Timed as `light_maps`: one set for all views that ask the same of light maps (RenderSettings' shadows,
    // area lights and detail), each drawn once. Sets that none of `views` uses are dropped.
    void draw_light_maps(const FrameScene& scene, std::span<FrameRenderer* const> views,
                         gpu::PassTimer& timer);
    // Whether the next update() lists what moved (GpuScene::movers()).
    void keep_before(bool keep) { gpu_scene_.keep_before(keep); }
    // What each view shows from its next FrameRenderer::compose() on, timed as `glow` within `composite`.
    void show(const Glows& glows) { glows_ = glows; }
    // The same from its next draw_gbuffer() on.
    void show(const Looks& looks) { looks_ = looks; }
    int light_map_sets() const { return static_cast<int>(sets_.size()); }

  private:
    friend class FrameRenderer;
    // For what a view with these settings draws from here on.
    void draw_for(const RenderSettings& settings) { gpu_scene_.use_levels(settings.adaptive_detail); }

    struct Set {
        RenderSettings settings;  // what light maps heed of them; the rest is as by default
        std::shared_ptr<LightMaps> maps;
        bool drawn = false;  // in this frame
    };
    Set& set_for(const FrameRenderer& view);

    GpuScene gpu_scene_;
    EmissiveTriangles emissive_;
    SkyTexture sky_;
    BlendPass blend_;
    std::unique_ptr<LinePass> lines_;  // null before there are any
    Glows glows_;
    Looks looks_;
    GlowPass glow_pass_;
    std::vector<Set> sets_;
    std::uint64_t sets_made_ = 0;
};

}  // namespace lanthorn::render
