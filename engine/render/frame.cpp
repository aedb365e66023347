#include "lanthorn/render/frame.h"

#include <cassert>
#include <utility>

namespace lanthorn::render {

void FrameRenderer::begin(const FrameScene& scene, ivec2 size, gpu::PassTimer& timer) {
    cut_ = !targets_ || targets_->gbuffer.size() != size;
    if (cut_) {
        targets_ = std::make_unique<Targets>(size);
    }
    indirect_ = {};
    const gpu::PassTimer::Scope pass(timer, "upload");
    gpu_scene_.use_levels(settings.adaptive_detail);
    gpu_scene_.update(scene);
    emissive_.update(scene);
    sky_.follow(scene);
}

void FrameRenderer::draw_light_maps(const FrameScene& scene, gpu::PassTimer& timer) {
    const gpu::PassTimer::Scope pass(timer, "light_maps");
    light_maps_.update(scene, gpu_scene_, emissive_, settings);
}

void FrameRenderer::draw_gbuffer(const FrameScene& scene, gpu::PassTimer& timer) {
    const gpu::PassTimer::Scope pass(timer, "gbuffer");
    targets_->gbuffer.draw(gpu_scene_, camera(scene));
}

void FrameRenderer::draw_direct(const FrameScene& scene, const TracedLobes& traced, gpu::PassTimer& timer) {
    const gpu::PassTimer::Scope pass(timer, "direct");
    targets_->direct.draw(targets_->gbuffer, light_maps_, camera(scene), traced.roughness);
}

void FrameRenderer::compose(const FrameScene& scene, const IndirectLight& indirect, gpu::PassTimer& timer) {
    const gpu::PassTimer::Scope pass(timer, "composite");
    indirect_ = indirect;
    Composite& composite = targets_->composite;
    composite.combine(targets_->gbuffer,
                      {&targets_->direct.radiance(), indirect.irradiance, indirect.specular}, sky_,
                      camera(scene));
    blend_.draw(scene, gpu_scene_, light_maps_, camera(scene), composite.radiance_framebuffer(), size());
    composite.display(settings, cut_);
}

LightInputs FrameRenderer::light_inputs(const FrameScene& scene, gpu::PassTimer& timer) const {
    return {scene, gpu_scene_, light_maps_, emissive_, sky_, timer};
}

FrameInputs FrameRenderer::inputs(const FrameScene& scene, gpu::PassTimer& timer) const {
    return {light_inputs(scene, timer), targets_->gbuffer, camera(scene)};
}

CameraUniforms FrameRenderer::camera(const FrameScene& scene) const {
    return CameraUniforms::from(scene.camera, static_cast<float>(size().x) / static_cast<float>(size().y));
}

void FrameRenderer::present(GLuint framebuffer, ivec2 size) const {
    const ivec2 from = targets_->gbuffer.size();
    glBlitNamedFramebuffer(targets_->composite.final_framebuffer().id(), framebuffer, 0, 0, from.x, from.y, 0,
                           0, size.x, size.y, GL_COLOR_BUFFER_BIT, from == size ? GL_NEAREST : GL_LINEAR);
}

}  // namespace lanthorn::render
