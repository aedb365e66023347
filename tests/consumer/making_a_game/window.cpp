// The room in a window: its light follows whatever moves in it.
//
//   window LEVEL.gltf
#include "lanthorn/shell/window.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"

using namespace lanthorn;

int main(int, char** argv) {
    shell::Window window({.title = "My room"});
    App app;
    add_scene_plugins(app);
    gi::add_picture_plugins(app, window.spending().preset);
    app.add<shell::WindowPlugin>(window);
    spawn_scene(app, import_gltf(argv[1]));
    app.view().camera = find_by_name(app.world(), "player-eyes");
    while (window.next_frame()) {
        window.draw(app);
    }
}
