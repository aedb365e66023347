#include "lanthorn/render/composite.h"

#include <cstddef>
#include <optional>

#include "engine/gpu/pass_end.h"
#include "engine/render/bloom.h"
#include "engine/render/combine_pass.h"
#include "engine/render/composite_state.h"
#include "engine/render/display_pass.h"
#include "engine/render/exposure_pass.h"
#include "engine/render/fxaa.h"

namespace lanthorn::render {

// In the order in which they work.
struct Composite::Stages {
    CombinePass combine;
    ExposurePass expose;
    std::optional<Bloom> scatter;  // once asked for
    DisplayPass display;
    std::optional<Fxaa> smooth;  // likewise
};

Composite::Composite(ivec2 size, const gpu::Texture& depth)
    : size_(size),
      radiance_(gpu::Texture::make_2d(GL_RGBA32F, size)),
      final_(gpu::Texture::make_2d(GL_RGBA8, size)),
      radiance_framebuffer_({&radiance_}, &depth),
      final_framebuffer_({&final_}, nullptr),
      state_(sizeof(CompositeState)),
      stages_(std::make_unique<Stages>()) {}

Composite::~Composite() = default;

void Composite::combine(const GBuffer& gbuffer, const Parts& parts, const SkyTexture& sky,
                        const CameraUniforms& camera, PixelStage stage) {
    stages_->combine.draw({gbuffer, parts, sky, brdf_table_, camera, state_}, stage,
                          {radiance_, radiance_framebuffer_, size_});
}

void Composite::take(const gpu::Texture& radiance) {
    glCopyImageSubData(radiance.id(), GL_TEXTURE_2D, 0, 0, 0, 0, radiance_.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                       size_.x, size_.y, 1);
}

void Composite::expose(const RenderSettings& settings, const Metering& metering) {
    stages_->expose.measure(radiance_, settings, metering, state_);
}

void Composite::expose_as(const Composite& other) {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glCopyNamedBufferSubData(other.state_.id(), state_.id(), offsetof(CompositeState, exposure),
                             offsetof(CompositeState, exposure), sizeof(CompositeState::exposure));
}

const gpu::Texture& Composite::scatter(float spread) {
    std::optional<Bloom>& bloom = stages_->scatter;
    if (!bloom) {
        bloom.emplace(size_);
    }
    bloom->scatter(radiance_, spread);
    return bloom->scattered();
}

void Composite::display(const RenderSettings& settings, const DisplayInputs& inputs) {
    stages_->display.draw({radiance_, inputs, state_}, settings, {final_, final_framebuffer_, size_});
    smoothed_ = false;
}

void Composite::smooth() {
    gpu::PassEnd::tell();
    std::optional<Fxaa>& fxaa = stages_->smooth;
    if (!fxaa) {
        fxaa.emplace(size_);
    }
    fxaa->smooth(final_);
    smoothed_ = true;
}

const gpu::Texture& Composite::unsmoothed() const {
    return smoothed_ ? stages_->smooth->source() : final_;
}

float Composite::exposure() const {
    return state_.read<CompositeState>(1).front().exposure;
}

std::uint32_t Composite::nan_count() const {
    return state_.read<CompositeState>(1).front().nan_count;
}

}  // namespace lanthorn::render
