#include "lanthorn/runtime/present_plugin.h"

#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/render_plugin.h"

namespace lanthorn {

namespace {

void present(ecs::Res<PresentTarget> target, ecs::Res<Renderer> renderer) {
    if (target->size.x <= 0 || target->size.y <= 0) {
        return;
    }
    renderer->frame->present(target->framebuffer, target->size);
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glViewport(0, 0, target->size.x, target->size.y);
}

}  // namespace

void PresentPlugin::build(App& app) {
    app.world().insert_resource(PresentTarget());
    app.frame_schedule().add("present", present).reads_resource<render::Composite>().on_main_thread();
}

}  // namespace lanthorn
