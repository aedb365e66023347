#include "lanthorn/render/frame.h"

#include <cassert>
#include <utility>

namespace lanthorn::render {

void FrameRenderer::render(const FrameScene& scene, ivec2 size, const IndirectPass& indirect,
                           gpu::PassTimer& timer) {
    const bool cut = !targets_ || targets_->gbuffer.size() != size;
    if (cut) {
        targets_ = std::make_unique<Targets>(size);
    }
    GBuffer& gbuffer = targets_->gbuffer;
    DirectLight& direct = targets_->direct;
    Composite& composite = targets_->composite;
    const auto camera =
        CameraUniforms::from(scene.camera, static_cast<float>(size.x) / static_cast<float>(size.y));

    {
        const gpu::PassTimer::Scope pass(timer, "upload");
        gpu_scene_.update(scene);
        emissive_.update(scene);
    }
    {
        const gpu::PassTimer::Scope pass(timer, "gbuffer");
        gbuffer.draw(gpu_scene_, camera);
    }
    {
        const gpu::PassTimer::Scope pass(timer, "light_maps");
        light_maps_.update(scene, gpu_scene_, emissive_, settings);
    }
    indirect_ = {};
    if (indirect) {
        const gpu::PassTimer::Scope pass(timer, "gi");
        indirect_ = indirect({scene, gpu_scene_, gbuffer, light_maps_, emissive_, camera, timer});
    }
    {
        const gpu::PassTimer::Scope pass(timer, "direct");
        direct.draw(gbuffer, light_maps_, camera);
    }
    {
        const gpu::PassTimer::Scope pass(timer, "composite");
        composite.combine(gbuffer, {&direct.radiance(), indirect_.irradiance, indirect_.specular});
        blend_.draw(scene, gpu_scene_, light_maps_, camera, composite.radiance_framebuffer(), size);
        composite.display(settings, cut);
    }
}

void FrameRenderer::present(GLuint framebuffer, ivec2 size) const {
    const ivec2 from = targets_->gbuffer.size();
    glBlitNamedFramebuffer(targets_->composite.final_framebuffer().id(), framebuffer, 0, 0, from.x, from.y, 0,
                           0, size.x, size.y, GL_COLOR_BUFFER_BIT, from == size ? GL_NEAREST : GL_LINEAR);
}

std::string FrameRenderer::reload_shaders() {
    std::string messages = light_maps_.reload_if_changed() + blend_.reload_if_changed();
    if (targets_) {
        messages += targets_->gbuffer.reload_if_changed() + targets_->direct.reload_if_changed() +
                    targets_->composite.reload_if_changed();
    }
    return messages;
}

}  // namespace lanthorn::render
