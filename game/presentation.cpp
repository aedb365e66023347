#include "game/presentation.h"

#include <epoxy/gl.h>

namespace lanthorn::game {

Presentation::Presentation(const SceneData& scene, const Level& level, const gpu::GlInfo&)
    : stage_(scene, level) {
    app_.add<RenderPlugin>().add<gi::GiPlugin>();
}

void Presentation::draw(const View& view, ivec2 size, const Settings& settings) {
    draw(stage_.show(view), size, settings);
}

void Presentation::draw(const View& view, const std::string& camera, ivec2 size, const Settings& settings) {
    draw(stage_.show(view, camera), size, settings);
}

void Presentation::draw(const FrameScene& scene, ivec2 size, const Settings& settings) {
    app_.world().insert_resource(scene);
    app_.view().size = size;
    gi::apply_settings(app_, settings);
    app_.show();
}

void Presentation::show(ivec2 size) const {
    renderer().present(0, size);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.x, size.y);
}

ImageF Presentation::picture() const {
    const render::FloatImage final = renderer().read(render::Aov::final);
    return {final.size.x, final.size.y, final.channels, final.pixels, {}};
}

}  // namespace lanthorn::game
