#include "engine/render/glow_pass.h"

#include <filesystem>

#include "engine/core/finite.h"
#include "engine/render/picture_strips.h"

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
    buffer_.hold(std::span<const PictureGlow>(shown_)).bind_storage(kPictureStripsBinding);
    if (!program_) {
        program_.emplace(
            std::vector<std::filesystem::path>{"engine/render/glow.vert", "engine/render/glow.frag"});
    }
    camera.set(*program_);
    PictureStrips(*program_, target, size, PictureStrips::Alpha::premultiplied).draw(shown_.size(), true);
}

}  // namespace lanthorn::render
