#include "lanthorn/render/frame.h"

#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/gpu/pass_end.h"
#include "engine/render/frame_targets.h"
#include "engine/render/scene_renderer.h"

namespace lanthorn::render {

FrameRenderer::FrameRenderer() : FrameRenderer(std::make_shared<SceneRenderer>()) {}

FrameRenderer::FrameRenderer(std::shared_ptr<SceneRenderer> shared) : shared_(std::move(shared)) {}

FrameRenderer::~FrameRenderer() = default;

void FrameRenderer::begin(const FrameScene& scene, ivec2 size, gpu::PassTimer& timer, ivec2 whole) {
    resize(size, whole);
    shared_->keep_before(upscales());
    shared_->update(scene, timer);
}

void FrameRenderer::resize(ivec2 size, ivec2 whole) {
    cut_ = !targets_ || targets_->gbuffer.size() != size;
    if (cut_) {
        targets_ = std::make_unique<Targets>(size);
    }
    indirect_ = {};
    std::unique_ptr<Upscaler>& upscaler = targets_->upscaler;
    const bool more =
        settings.upscale != Upscale::none && whole != size && whole.x >= size.x && whole.y >= size.y;
    if (!more) {
        upscaler.reset();
    } else if (!upscaler || upscaler->size() != whole) {
        upscaler = std::make_unique<Upscaler>(size, whole);
        upscaled_ = 0;
    }
}

void FrameRenderer::restart() {
    if (!targets_) {
        return;
    }
    targets_->drawn.reset();
    if (targets_->upscaler) {
        targets_->upscaler->restart();
    }
}

bool FrameRenderer::upscales() const {
    return targets_ && targets_->upscaler && settings.upscale == Upscale::temporal;
}

void FrameRenderer::draw_light_maps(const FrameScene& scene, gpu::PassTimer& timer) {
    FrameRenderer* const alone = this;
    shared_->draw_light_maps(scene, {&alone, 1}, timer);
}

void FrameRenderer::draw_gbuffer(const FrameScene& scene, gpu::PassTimer& timer) {
    const gpu::PassTimer::Scope pass(timer, "gbuffer");
    targets_->keeps_surfaces = shows_the_same_surfaces(scene);
    if (targets_->keeps_surfaces) {
        targets_->drawn->frame = scene.frame;
        return;
    }
    targets_->drawn = {scene.frame, scene.camera, scene.origin, settings, std::nullopt, 0, shared_->looks_};
    shared_->draw_for(settings);
    if (upscales()) {
        const vec2 share = vec2(size()) / vec2(targets_->upscaler->size());
        shared_->gpu_scene_.set_texture_bias(0.5f * std::log2(share.x * share.y));
    }
    targets_->gbuffer.draw(shared_->gpu_scene_, camera(scene), &shared_->looks_);
    draw_blended_surfaces(camera(scene));
    shared_->gpu_scene_.set_texture_bias(0);
}

void FrameRenderer::draw_blended_surfaces(const CameraUniforms& camera) {
    std::vector<std::uint32_t> visible;
    shared_->gpu_scene_.find_visible(DrawSet::blend, camera.frustum(), visible);
    if (visible.empty()) {
        targets_->blended.reset();
        return;
    }
    if (!targets_->blended) {
        targets_->blended = std::make_unique<GBuffer>(size(), DrawSet::blend);
    }
    targets_->blended->draw_before(targets_->gbuffer, shared_->gpu_scene_, camera);
}

// A jittered picture looks elsewhere in every frame.
bool FrameRenderer::shows_the_same_surfaces(const FrameScene& scene) const {
    const SceneChanges& c = scene.changes;
    const std::optional<Targets::Drawn>& drawn = targets_->drawn;
    const bool follows = drawn && settings.still_kept && !upscales() &&
                         (scene.frame == drawn->frame || scene.frame == drawn->frame + 1);
    return follows && !c.assets && !c.geometry && !c.replaced && c.painted.empty() && !c.pattern &&
           !c.emission && !c.relief && drawn->camera == scene.camera && drawn->origin == scene.origin &&
           drawn->settings == settings && drawn->looks == shared_->looks_;
}

void FrameRenderer::draw_direct(const FrameScene& scene, const TracedLobes& traced, gpu::PassTimer& timer) {
    const gpu::PassTimer::Scope pass(timer, "direct");
    Targets::Drawn& drawn = *targets_->drawn;
    if (traced.lamps) {
        drawn.light_maps.reset();
        return;
    }
    const std::uint64_t version = light_maps().version();
    if (targets_->keeps_surfaces && !scene.changes.lights && drawn.light_maps == version &&
        drawn.traced_roughness == traced.roughness) {
        return;
    }
    drawn.light_maps = version;
    drawn.traced_roughness = traced.roughness;
    targets_->direct.draw(targets_->gbuffer, light_maps(), camera(scene), traced.roughness,
                          settings.pixel_stage);
}

void FrameRenderer::compose(const FrameScene& scene, const IndirectLight& indirect, gpu::PassTimer& timer,
                            const FrameRenderer* exposed_as) {
    const gpu::PassTimer::Scope pass(timer, "composite");
    indirect_ = indirect;
    shared_->draw_for(settings);
    Composite& composite = targets_->composite;
    if (indirect.radiance != nullptr) {
        composite.take(*indirect.radiance);
    } else {
        if (indirect.lamps != nullptr) {
            targets_->direct.take(targets_->gbuffer, *indirect.lamps, composite.brdf_table(), camera(scene));
        }
        composite.combine(targets_->gbuffer,
                          {&targets_->direct.radiance(), indirect.irradiance, indirect.specular},
                          shared_->sky_, camera(scene), settings.pixel_stage);
        gpu::PassEnd::tell();
        const BlendPass::Light light{indirect.irradiance, &targets_->gbuffer.distance(),
                                     indirect.blended_irradiance,
                                     targets_->blended ? &targets_->blended->distance() : nullptr};
        shared_->blend_.draw(scene, shared_->gpu_scene_, light_maps(), camera(scene), light,
                             composite.radiance_framebuffer(), size());
    }
    if (settings.air_scattering > 0) {
        const gpu::PassTimer::Scope air(timer, "air");
        if (!targets_->air) {
            targets_->air = std::make_unique<AirLight>(size());
        }
        targets_->air->add(targets_->gbuffer, light_maps(), camera(scene),
                           {settings.air_scattering, settings.air_steps, scene.diagonal()},
                           composite.radiance_framebuffer());
    }
    if (!shared_->glows_.glows.empty()) {
        const gpu::PassTimer::Scope glow(timer, "glow");
        shared_->glow_pass_.draw(shared_->glows_.glows, camera(scene), scene.origin,
                                 composite.radiance_framebuffer(), size());
    }
    show(scene, timer, exposed_as);
}

void FrameRenderer::show(const FrameScene& scene, gpu::PassTimer& timer, const FrameRenderer* exposed_as) {
    Composite& composite = targets_->composite;
    const CameraUniforms looked = camera(scene);
    const Composite::Fuzzy fuzzy{targets_->gbuffer, looked};
    // What indirect light brings as a whole is shown as it is.
    const bool rims = settings.rim > 0 && indirect_.radiance == nullptr && shared_->looks_.have_rims();
    Composite::DisplayInputs over{.fuzzy = rims ? &fuzzy : nullptr};
    composite.expose(settings, {.reset = cut_, .around = rims});
    if (exposed_as != nullptr) {
        composite.expose_as(exposed_as->targets_->composite);
    }
    if (settings.bloom_share > 0) {
        const gpu::PassTimer::Scope bloom(timer, "bloom");
        over.scattered = &composite.scatter(settings.bloom_spread);
    }
    composite.display(settings, over);
    if (settings.antialias || upscales()) {
        composite.smooth();
    }
}

void FrameRenderer::upscale(const FrameScene& scene, gpu::PassTimer& timer) {
    if (!targets_->upscaler) {
        return;
    }
    const gpu::PassTimer::Scope pass(timer, "upscale");
    CameraUniforms through = through_middles(scene);
    // A picture that indirect light brings as a whole looks through the middles.
    const bool whole = indirect_.radiance != nullptr;
    CameraUniforms looked = camera(scene);
    looked.shift = whole ? vec2(0) : looked.shift;
    const bool still = scene.changes.nothing() && looked_ == scene.camera;
    targets_->upscaler->add(
        {targets_->composite.unsmoothed(), targets_->composite.final(), targets_->gbuffer,
         shared_->gpu_scene_, looked, through, still, scene.changes.replaced, scene.origin},
        settings);
    looked_ = scene.camera;
    ++upscaled_;
}

void FrameRenderer::draw_lines(const FrameScene& scene, std::span<const Line> some,
                               std::span<const Line> more, gpu::PassTimer& timer) {
    if (some.empty() && more.empty()) {
        return;
    }
    const gpu::PassTimer::Scope pass(timer, "lines");
    if (!shared_->lines_) {
        shared_->lines_ = std::make_unique<LinePass>();
    }
    shared_->lines_->draw(some, more, camera(scene), scene.origin, targets_->display, size());
}

LightInputs FrameRenderer::light_inputs(const FrameScene& scene, gpu::PassTimer& timer) const {
    shared_->draw_for(settings);
    return {scene, shared_->gpu_scene_, light_maps(), shared_->emissive_, shared_->sky_, timer};
}

FrameInputs FrameRenderer::inputs(const FrameScene& scene, gpu::PassTimer& timer) const {
    return {light_inputs(scene, timer), targets_->gbuffer, camera(scene), targets_->blended.get()};
}

CameraUniforms FrameRenderer::camera(const FrameScene& scene) const {
    const CameraUniforms through = through_middles(scene);
    return upscales() ? through.shifted(targets_->upscaler->shift(upscaled_), size()) : through;
}

CameraUniforms FrameRenderer::through_middles(const FrameScene& scene) const {
    return CameraUniforms::from(scene.camera, static_cast<float>(size().x) / static_cast<float>(size().y));
}

ivec2 FrameRenderer::size() const {
    return targets_ ? targets_->gbuffer.size() : ivec2(0);
}

ivec2 FrameRenderer::final_size() const {
    return targets_ && targets_->upscaler ? targets_->upscaler->size() : size();
}

const gpu::Texture& FrameRenderer::final() const {
    return targets_->upscaler ? targets_->upscaler->whole() : targets_->composite.final();
}

const gpu::Texture& FrameRenderer::upscaled_history() const {
    return targets_->upscaler->history();
}

void FrameRenderer::present(GLuint framebuffer, ivec2 size, ivec2 corner) const {
    const ivec2 from = final_size();
    const ivec2 to = corner + size;
    const gpu::Framebuffer& shown =
        targets_->upscaler ? targets_->upscaler->framebuffer() : targets_->composite.final_framebuffer();
    glBlitNamedFramebuffer(shown.id(), framebuffer, 0, 0, from.x, from.y, corner.x, corner.y, to.x, to.y,
                           GL_COLOR_BUFFER_BIT, from == size ? GL_NEAREST : GL_LINEAR);
}

std::uint32_t FrameRenderer::nan_count() const {
    return targets_->composite.nan_count();
}

float FrameRenderer::exposure() const {
    return targets_->composite.exposure();
}

const GpuScene& FrameRenderer::gpu_scene() const {
    return shared_->gpu_scene_;
}

const LightMaps& FrameRenderer::light_maps() const {
    assert(light_maps_);
    return *light_maps_;
}

const EmissiveTriangles& FrameRenderer::emissive() const {
    return shared_->emissive_;
}

const GBuffer& FrameRenderer::gbuffer() const {
    return targets_->gbuffer;
}

}  // namespace lanthorn::render
