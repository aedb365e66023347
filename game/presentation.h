// What the game looks like: the stage, rendered with indirect light. The simulation never reads from here.
#pragma once

#include "game/stage.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/render_plugin.h"

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
    const render::FrameRenderer& renderer() const { return *app_.world().resource<Renderer>().frame; }

  private:
    void draw(const FrameScene& scene, ivec2 size, const Settings& settings);

    Stage stage_;
    App app_;
};

}  // namespace lanthorn::game
