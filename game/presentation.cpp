#include "game/presentation.h"

#include <epoxy/gl.h>

namespace lanthorn::game {

Presentation::Presentation(const SceneData& scene, const Level& level, const gpu::GlInfo& gl)
    : stage_(scene, level), timer_(false, gl.software) {}

void Presentation::draw(const View& view, ivec2 size, const Settings& settings) {
    draw(stage_.show(view), size, settings);
}

void Presentation::draw(const View& view, const std::string& camera, ivec2 size, const Settings& settings) {
    draw(stage_.show(view, camera), size, settings);
}

void Presentation::draw(const FrameScene& scene, ivec2 size, const Settings& settings) {
    const gi::GiSettings gi = gi::gi_settings(settings);
    if (!technique_ || kind_ != gi.technique) {
        technique_ = gi::make_technique(gi.technique);
        kind_ = gi.technique;
    }
    renderer_.settings = render::render_settings(settings);
    renderer_.render(
        scene, size, [&](const render::FrameInputs& inputs) { return technique_->render(inputs, gi); },
        timer_);
}

void Presentation::show(ivec2 size) const {
    renderer_.present(0, size);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.x, size.y);
}

ImageF Presentation::picture() const {
    const render::FloatImage final = renderer_.read(render::Aov::final);
    return {final.size.x, final.size.y, final.channels, final.pixels, {}};
}

}  // namespace lanthorn::game
