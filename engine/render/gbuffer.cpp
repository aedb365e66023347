#include "lanthorn/render/gbuffer.h"

#include "engine/render/scene_textures.h"

namespace lanthorn::render {

using gpu::Texture;

GBuffer::GBuffer(ivec2 size, DrawSet of)
    : size_(size),
      of_(of),
      distance_(Texture::make_2d(GL_R32F, size)),
      normals_(Texture::make_2d(GL_RGBA16_SNORM, size)),
      albedo_(Texture::make_2d(GL_RGBA16, size)),
      material_(Texture::make_2d(GL_RGBA8, size)),
      emissive_(Texture::make_2d(GL_RGBA16F, size)),
      depth_(Texture::make_2d(GL_DEPTH_COMPONENT32F, size)),
      framebuffer_({&distance_, &normals_, &albedo_, &material_, &emissive_}, &depth_),
      program_("engine/render/gbuffer.vert", "engine/render/gbuffer.frag",
               of == DrawSet::blend ? std::vector<std::string>{"BLENDED"} : std::vector<std::string>()) {}

void GBuffer::draw(const GpuScene& gpu_scene, const CameraUniforms& camera, const GBuffer* behind) {
    // Half floats hold emission as a share of the scene's brightest, so that any unit of light fits.
    emissive_scale_ = gpu_scene.max_emissive() > 0 ? gpu_scene.max_emissive() : 1.0f;
    framebuffer_.bind(size_);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    const vec4 zero(0);
    const float far_depth = 0;
    for (GLint i = 0; i < 5; ++i) {
        glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, i, &zero.x);
    }
    glClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &far_depth);
    program_.prepare(gpu_scene.variants());
    camera.set(program_);
    program_.set("emissive_scale", emissive_scale_);
    if (behind != nullptr) {
        constexpr GLuint kUnit = static_cast<GLuint>(kMaterialTextures);
        behind->distance().bind(kUnit);
        program_.set("distance_behind", static_cast<int>(kUnit));
    }
    gpu_scene.find_visible(of_, camera.frustum(), visible_);
    const float pixel = 2 * glm::length(camera.up) / static_cast<float>(size_.y);
    const TexelSize texel{camera.position, camera.orthographic ? 0 : pixel, camera.orthographic ? pixel : 0};
    drawn_.clear();
    for (const std::uint32_t i : visible_) {
        drawn_.push_back({i, gpu_scene.picture_level(i, texel)});
    }
    gpu_scene.draw(program_, drawn_);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace lanthorn::render
