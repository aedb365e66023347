// Plays the room: the crystal sleeps while the shutter is shut, and wakes by what the red wall reflects.
//
//   puzzle LEVEL.gltf FOLDER      writes FOLDER/asleep.png and FOLDER/awake.png
#include <cstdio>
#include <exception>
#include <string>

#include "crystal.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/runtime/sensor_plugin.h"
#include "lanthorn/scene/spawn.h"
#include "shutter.h"

using namespace mine;

// So many seconds of play, at 15 pictures a second.
void play(App& app, double seconds) {
    for (int frame = 0; frame < seconds * 15; ++frame) {
        app.frame(1.0 / 15);
    }
}

bool report(App& app, const std::string& picture) {
    const ecs::Entity crystal = find_by_name(app.world(), "crystal");
    const bool awake = app.world().get<Crystal>(crystal).awake;
    write_image(picture, app.world().resource<Renderer>().frame->read(render::Aov::final));
    std::printf("%s: the sensor reads %.2f lux, the crystal %s\n", picture.c_str(),
                static_cast<double>(app.world().get<LightSensor>(crystal).lux),
                awake ? "is awake" : "sleeps");
    return awake;
}

int run(const char* level, const std::string& folder) {
    const auto context = gpu::create_headless_context();
    App app;
    add_scene_plugins(app);
    app.add<SensorPlugin>().add<ShutterPlugin>().add<CrystalPlugin>();
    app.add<RenderPlugin>().add<gi::GiPlugin>();
    spawn_scene(app, import_gltf(level));
    app.view() = {.size = {320, 180}, .camera = find_by_name(app.world(), "camera"), .placed = {}};

    play(app, 1);
    const bool woke_early = report(app, folder + "/asleep.png");
    app.world().resource_mut<Hand>().uses = true;
    app.step();
    app.world().resource_mut<Hand>().uses = false;
    play(app, 3);
    const bool awake = report(app, folder + "/awake.png");
    return awake && !woke_early ? 0 : 1;
}

int main(int argc, char** argv) {
    try {
        return argc == 3 ? run(argv[1], argv[2]) : 2;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "puzzle: %s\n", e.what());
        return 2;
    }
}
