// Hello, Lanthorn: the smallest program that uses the engine. Copy it.
//
//   hello SCENE.glb PICTURE.png
//
// It moves a lamp through a scene by a system of its own and writes the picture with its indirect light.
#include <cstdio>
#include <exception>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"

using namespace lanthorn;

// Components are plain types; anything movable will do.
struct Drift {
    dvec3 velocity{0};  // metres a second
};

// A system is a function. Its parameters say what it reads and writes, and the schedule orders it
// accordingly.
void drift(ecs::Query<ecs::Write<LocalTransform>, ecs::Read<Drift>> things) {
    things.each(
        [](LocalTransform& at, const Drift& drift) { at.value.translation += drift.velocity / 60.0; });
}

int run(const char* scene_file, const char* picture_file) {
    // A context without a window; gpu::WindowContext opens one. It outlives what draws in it.
    const auto context = gpu::create_headless_context();

    // An App is a world and two schedules; plugins add the engine's systems to them.
    App app;
    add_scene_plugins(app);
    app.add<RenderPlugin>().add<gi::GiPlugin>();
    app.fixed_schedule().add("drift", drift).in("gameplay");

    // A scene becomes entities of the world: one a node.
    ecs::World& world = app.world();
    const std::vector<ecs::Entity> nodes = spawn(world, import_gltf(scene_file));

    // Our own component on every light, and a light of our own.
    for (const ecs::Entity light : world.query<ecs::With<LightComponent>>().entities()) {
        world.add(light, Drift{{0.1, 0, 0}});
    }
    Light glow;
    glow.intensity = 20;  // candela
    world.create(LocalTransform{{.translation = {0, 1, 0}}}, LightComponent{glow}, Drift{{0, 0.1, 0}});

    app.view().size = {160, 120};
    app.view().camera = find_by_name(world, "camera");
    // The defaults fit larger pictures.
    world.resource_mut<gi::GiSettings>().edit<gi::EmcSettings>().gather_rays = 2;

    // Simulate and show. Only what changed since the frame before costs anything.
    for (int frame = 0; frame < 3; ++frame) {
        app.frame(1.0 / 60);
    }

    const ImageF picture = world.resource<Renderer>().frame->read(render::Aov::final);
    write_image(picture_file, picture);

    double brightness = 0;
    for (const float value : picture.pixels) {
        brightness += value / static_cast<double>(picture.pixels.size());
    }
    std::printf("%zu nodes, mean brightness %.3f, picture in %s\n", nodes.size(), brightness, picture_file);
    return brightness > 0.05 && brightness < 0.95 ? 0 : 1;
}

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: hello SCENE.glb PICTURE.png\n");
        return 2;
    }
    try {
        return run(argv[1], argv[2]);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "hello: %s\n", e.what());
        return 2;
    }
}
