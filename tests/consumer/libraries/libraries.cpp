// A figure walks for half a second, is skinned, and is lit by the path tracer; no OpenGL.
//
//   libraries SCENE.glb        a scene with a skinned figure and at least one clip
#include <cstdio>
#include <exception>

#include "lanthorn/animation/animator.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/coarse-path/coarse_path.h"
#include "lanthorn/core/error.h"
#include "lanthorn/deformation/deformation.h"
#include "lanthorn/physics/physics.h"
#include "lanthorn/reference/path_tracer.h"
#include "lanthorn/replay/content_hash.h"
#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"
#include "lanthorn/workbench/load_scene.h"
#include "lanthorn/workbench/metrics.h"

using namespace lanthorn;

void expect(bool holds, const char* what) {
    if (!holds) {
        throw InputError(what);
    }
}

int run(const char* file) {
    ecs::World world;
    spawn(world, import_gltf(file));

    const auto figures = world.query<ecs::With<AnimationSet>>().entities();
    expect(!figures.empty(), "no animation in the scene");
    AnimationPlayer player;
    play(player, world.get<AnimationSet>(figures.front()), 0);
    world.add(figures.front(), std::move(player));

    Animator animator;
    physics::Physics physics;
    Transforms transforms;
    Deformation deformation;
    for (int step = 0; step < 30; ++step) {
        animator.animate(world, 1.0 / 60);
        transforms.update(world);
        physics.step(world);
    }
    transforms.update(world);
    deformation.update(world);
    Extractor extractor;
    const FrameScene frame =
        extractor.extract(world, world.query<ecs::With<CameraComponent>>().entities().front());

    reference::PathSettings settings;
    settings.spp = 2;
    reference::PathTracer tracer(frame, {16, 16}, settings, {.indirect = true});
    expect(tracer.render({}).spp == 2, "the path tracer stopped early");
    double lux = 0;
    for (const float value : tracer.image(reference::PathAov::indirect)) {
        lux += value;
    }
    expect(lux > 0, "no indirect light");
    for (const char* name : {"emc", "coarse-path", "drm", "vertex-map", "splat"}) {
        expect(gi::find_technique(name) != nullptr, name);
    }
    const auto rival = gi::make_technique(gi::add_coarse_path());
    expect(!rival->statistics(false).plan.on("paths"), "a plan without a frame");

    workbench::SceneView view;
    view.camera = "auto";
    ShownScene shown(workbench::load_scene(file, view), view);
    shown.show_at(0.5);
    expect(!shown.frame().instances.empty(), "a scene is shown without geometry");
    const ImageF grey{2, 1, 1, {0.5f, 0.5f}, {}}, darker{2, 1, 1, {0.4f, 0.4f}, {}};
    expect(workbench::compare(darker, grey, "darker", "grey").all.bias < 0, "darker is not darker");

    std::printf("%zu bodies, %s with hash %016llx\n", physics.body_count(), file,
                static_cast<unsigned long long>(replay::hash_file(file)));
    return 0;
}

int main(int argc, char** argv) {
    try {
        return argc == 2 ? run(argv[1]) : 2;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "libraries: %s\n", e.what());
        return 1;
    }
}
