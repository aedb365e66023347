#include "tools/editor/core/document_light_costs.h"

#include <epoxy/gl.h>

#include <utility>

#include "lanthorn/gi/gi_plugin.h"

namespace lanthorn::editor {

std::unique_ptr<workbench::LightCosts> document_light_costs(const EditSession& session,
                                                            const Settings& settings, ivec2 size) {
    const EditSession::Copy copy(session.document());
    workbench::SceneView view = session.view();
    SceneData scene = workbench::load_scene(copy.file().string(), view);
    view.camera = workbench::add_pose_camera(scene, session.pose());
    auto shown = std::make_shared<ShownScene>(std::move(scene), view);
    gi::add_picture_plugins(shown->app(), settings);
    shown->app().view().size = size;
    ecs::World& world = shown->world();
    return std::make_unique<workbench::LightCosts>(world, workbench::punctual_lamps(world), [shown] {
        shown->show_at(0);
        glFinish();
    });
}

}  // namespace lanthorn::editor
