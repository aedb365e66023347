// Uses the level's shutter and tells where it is after a second. Simulation alone: no OpenGL.
//
//   use LEVEL.gltf
#include <cmath>
#include <cstdio>
#include <exception>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "shutter.h"

using namespace mine;

int run(const char* level) {
    App app;
    add_scene_plugins(app);
    app.add<ShutterPlugin>();
    spawn_scene(app, import_gltf(level));
    const ecs::Entity shutter = find_by_name(app.world(), "shutter");
    const dvec3 shut = app.world().get<LocalTransform>(shutter).value.translation;

    app.world().resource_mut<Hand>().uses = true;
    app.step();
    app.world().resource_mut<Hand>().uses = false;
    for (int step = 1; step < 60; ++step) {
        app.step();
    }

    const dvec3 slid = app.world().get<LocalTransform>(shutter).value.translation - shut;
    std::printf("the shutter slid by %.3f %.3f %.3f m\n", slid.x, slid.y, slid.z);
    return app.world().get<Shutter>(shutter).open && std::abs(glm::length(slid) - 1.5) < 1e-9 ? 0 : 1;
}

int main(int argc, char** argv) {
    try {
        return argc == 2 ? run(argv[1]) : 2;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "use: %s\n", e.what());
        return 2;
    }
}
