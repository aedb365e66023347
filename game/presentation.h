// What the game looks like: the stage, rendered with indirect light. The simulation never reads from here.
#pragma once

#include <memory>

#include "game/stage.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::game {

class Presentation {
  public:
    // Needs a current context for as long as it lives.
    Presentation(const SceneData& scene, const Level& level, const gpu::GlInfo& gl);

    // Renders a frame of `size` pixels, seen by the player or by one of the scene's cameras.
    void draw(const View& view, ivec2 size, const Settings& settings);
    void draw(const View& view, const std::string& camera, ivec2 size, const Settings& settings);

    // Copies the last frame to the window's framebuffer of `size` pixels and leaves that bound, to be drawn
    // over.
    void show(ivec2 size) const;
    // The last frame as it is to be seen: sRGB-encoded RGB.
    ImageF picture() const;
    const render::FrameRenderer& renderer() const { return renderer_; }

  private:
    void draw(const FrameScene& scene, ivec2 size, const Settings& settings);

    Stage stage_;
    render::FrameRenderer renderer_;
    gpu::PassTimer timer_;
    gi::TechniqueKind kind_ = gi::TechniqueKind::none;
    std::unique_ptr<gi::Technique> technique_;
};

}  // namespace lanthorn::game
