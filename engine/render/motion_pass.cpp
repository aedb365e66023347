#include "engine/render/motion_pass.h"

#include <algorithm>
#include <span>

namespace lanthorn::render {

namespace {
constexpr GLuint kBeforeBinding = 2;  // motion.vert
constexpr GLuint kDistanceUnit = 8;   // after those of materials
}  // namespace

MotionPass::MotionPass(ivec2 size)
    : size_(size),
      motion_(gpu::Texture::make_2d(GL_RGBA32F, size)),
      framebuffer_({&motion_}, nullptr),
      program_({"engine/render/motion.vert", "engine/render/motion.frag"}) {}

bool MotionPass::draw(const GBuffer& gbuffer, const GpuScene& scene, const CameraUniforms& camera,
                      const CameraUniforms& before) {
    rigid_.clear();
    bent_.clear();
    transforms_.clear();
    const std::span<const GpuScene::Mover> movers = scene.movers();
    for (const DrawnInstance& drawn : gbuffer.drawn()) {
        const auto mover = std::ranges::lower_bound(movers, drawn.instance, {}, &GpuScene::Mover::instance);
        if (mover == movers.end() || mover->instance != drawn.instance) {
            continue;
        }
        DrawnInstance tagged = drawn;
        tagged.first_layer = static_cast<std::uint32_t>(transforms_.size());
        transforms_.push_back(mover->before);
        (mover->bent ? bent_ : rigid_).push_back(tagged);
    }
    if (transforms_.empty()) {
        return false;
    }
    const vec4 none(0);
    glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 0, &none.x);
    framebuffer_.bind(size_);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    camera.set(program_);
    program_.set("shift", camera.shift);
    set_before(program_, before);
    program_.set("gbuffer_distance", static_cast<int>(kDistanceUnit));
    gbuffer.distance().bind(kDistanceUnit);
    before_.hold(std::span<const mat4>(transforms_)).bind_storage(kBeforeBinding);
    scene.draw_before(program_, rigid_, false);
    scene.draw_before(program_, bent_, true);
    return true;
}

void set_before(const gpu::Program& program, const CameraUniforms& before) {
    program.set("before_position", before.position);
    program.set("before_forward", before.forward);
    program.set("before_clip_from_relative", before.clip_from_relative);
}

}  // namespace lanthorn::render
