// A room in ten lines: opens a level and writes a picture of it with its indirect light.
//
//   room LEVEL.gltf PICTURE.png
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"

using namespace lanthorn;

int main(int, char** argv) {
    const auto context = gpu::create_headless_context();
    App app;
    add_scene_plugins(app);
    app.add<RenderPlugin>().add<gi::GiPlugin>();
    spawn_scene(app, import_gltf(argv[1]));
    app.view() = {.size = {320, 180}, .camera = find_by_name(app.world(), "player-eyes"), .placed = {}};
    app.show();
    write_image(argv[2], app.world().resource<Renderer>().frame->read(render::Aov::final));
}
