// The sky's image on the GPU, for the background of the picture.
#pragma once

#include <memory>
#include <optional>

#include "lanthorn/gpu/texture.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::render {

class SkyTexture {
  public:
    // Uploads the image if it is another one. O(pixels) then.
    void follow(const FrameScene& scene);

    bool empty() const { return !texture_; }  // there is no sky to show
    // Sets sky_image (texture unit `unit`), sky_scale and render_to_sky of a program that includes sky.glsl.
    // Not for an empty one.
    template <class AnyProgram>
    void bind(const AnyProgram& program, GLuint unit) const {
        texture_.bind(unit);
        program.set("sky_image", static_cast<int>(unit));
        program.set("sky_scale", scale_);
        program.set("render_to_sky", to_sky_);
    }

  private:
    std::shared_ptr<const SkyImage> image_;
    gpu::Texture texture_;
    float unit_ = 1;  // nits of 1 in the texture
    vec3 scale_{0};   // nits of 1 in the texture, times the sky's own factors
    mat3 to_sky_{1};
};

}  // namespace lanthorn::render
