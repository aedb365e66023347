// Hello, Lanthorn: the smallest program that uses the engine. Copy it.
//
//   hello SCENE.glb PICTURE.png
//
// It moves a lamp through a scene by a system of its own and writes the picture with its indirect light.
#include <cstdio>
#include <exception>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/ecs/schedule.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"

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
    // A scene becomes entities of a world: one a node.
    ecs::World world;
    const std::vector<ecs::Entity> nodes = spawn(world, import_gltf(scene_file));

    // Our own component on every light, and a light of our own.
    for (const ecs::Entity light : world.query<ecs::With<LightComponent>>().entities()) {
        world.add(light, Drift{{0.1, 0, 0}});
    }
    Light glow;
    glow.intensity = 20;  // candela
    world.create(LocalTransform{{.translation = {0, 1, 0}}}, LightComponent{glow}, Drift{{0, 0.1, 0}});

    ecs::Schedule simulation("simulation");
    simulation.add("drift", drift);
    simulation.add("transforms", [t = Transforms()](ecs::World& w) mutable { t.update(w); });

    // A context without a window; gpu::WindowContext opens one.
    const auto context = gpu::create_headless_context();
    render::FrameRenderer renderer;
    gpu::PassTimer timer(false, context->info().software);
    const auto technique = gi::make_technique(gi::TechniqueKind::emc);
    gi::GiSettings settings;
    settings.photons = 5000;

    // Simulate, take a snapshot, render it. Only what changed since the snapshot before costs anything.
    Extractor extractor;
    const ecs::Entity camera = find_by_name(world, "camera");
    for (int frame = 0; frame < 3; ++frame) {
        simulation.run(world);
        renderer.render(
            extractor.extract(world, camera), {160, 120},
            [&](const render::FrameInputs& inputs) { return technique->render(inputs, settings); }, timer);
    }

    const render::FloatImage picture = renderer.read(render::Aov::final);
    write_image(picture_file, {picture.size.x, picture.size.y, picture.channels, picture.pixels, {}});

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
