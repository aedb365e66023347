// What the game looks like: the scene on a stage of its own that follows the simulation's views, rendered
// with indirect light. The simulation never reads from here.
#pragma once

#include <memory>

#include "engine/assets/image_io.h"
#include "engine/core/settings.h"
#include "engine/gpu/context.h"
#include "engine/scene/scene_data.h"
#include "game/level.h"
#include "game/simulation.h"

namespace lanthorn::game {

class Presentation {
  public:
    // Needs a current context for as long as it lives.
    Presentation(const SceneData& scene, const Level& level, const gpu::GlInfo& gl);
    ~Presentation();

    // Renders a frame of `size` pixels.
    void draw(const View& view, ivec2 size, const Settings& settings);

    // Copies the last frame to the window's framebuffer of `size` pixels.
    void show(ivec2 size) const;
    // The last frame as it is to be seen: sRGB-encoded RGB.
    ImageF picture() const;
    // Mean indirect irradiance over the last frame's pixels, lux.
    double mean_indirect() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace lanthorn::game
