#include "engine/render/glow_pass.h"

#include <filesystem>

#include "engine/core/finite.h"
#include "engine/render/fullscreen.h"

namespace lanthorn::render {

void GlowPass::draw(std::span<const Glow> glows, const CameraUniforms& camera, const dvec3& origin,
                    const gpu::Framebuffer& target, ivec2 size) {
    const dvec3 eye = origin + dvec3(camera.position);
    shown_.clear();
    for (const Glow& glow : glows) {
        const vec3 foot(glow.foot - eye), tip(glow.tip - eye);
        if (glow.width > 0 && foot != tip && is_finite(foot) && is_finite(tip) && is_finite(glow.nits)) {
            shown_.push_back({vec4(foot, glow.width), vec4(tip, glow.width), vec4(glow.nits, 0)});
        }
    }
    if (shown_.empty()) {
        return;
    }
    buffer_.hold(std::span<const PictureGlow>(shown_)).bind_storage(kPictureGlowsBinding);
    if (!program_) {
        program_.emplace(
            std::vector<std::filesystem::path>{"engine/render/glow.vert", "engine/render/glow.frag"});
    }
    camera.set(*program_);
    target.bind(size);
    program_->use();
    bind_no_vertices();
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(shown_.size()));
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace lanthorn::render
