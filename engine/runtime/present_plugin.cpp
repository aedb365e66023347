#include "lanthorn/runtime/present_plugin.h"

#include <algorithm>

#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/render_plugin.h"

namespace lanthorn {

namespace {

void present(ecs::Res<PresentTarget> target, ecs::Res<Renderer> renderer) {
    if (target->size.x <= 0 || target->size.y <= 0) {
        return;
    }
    const auto show = [&](const Pane& pane) {
        const auto shown =
            std::ranges::find_if(renderer->views, [&](const auto& view) { return view->id == pane.view; });
        if (shown != renderer->views.end() && pane.size.x > 0 && pane.size.y > 0) {
            (*shown)->frame->present(target->framebuffer, pane.size, pane.corner);
        }
    };
    if (target->panes.empty()) {
        show({ViewId::first, ivec2(0), target->size});
    } else {
        const vec4 black(0, 0, 0, 1);
        glClearNamedFramebufferfv(target->framebuffer, GL_COLOR, 0, &black.x);
        std::ranges::for_each(target->panes, show);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glViewport(0, 0, target->size.x, target->size.y);
}

}  // namespace

void PresentPlugin::build(App& app) {
    app.world().insert_resource(PresentTarget());
    app.frame_schedule().add("present", present).reads_resource<render::Composite>().on_main_thread();
}

}  // namespace lanthorn
