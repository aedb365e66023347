#include "tests/fuzz/played_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "lanthorn/animation/animator.h"
#include "lanthorn/deformation/deformation.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn {

namespace {

bool finite(const vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

void expect_plays(SceneData scene) {
    ecs::World world;
    spawn(world, std::move(scene));
    Animator animator;
    Transforms transforms;
    Deformation deformation;
    const auto show = [&] {
        animator.animate(world, 0.37);
        transforms.update(world);
        deformation.update(world);
        world.query<ecs::Read<LocalTransform>>().each([](const LocalTransform& local) {
            ASSERT_TRUE(finite(local.value.translation) && finite(local.value.scale));
            ASSERT_NEAR(glm::length(local.value.rotation), 1, 1e-4);
        });
        world.query<ecs::Read<DeformedMeshes>>().each([](const DeformedMeshes& meshes) {
            for (const DeformedMesh& mesh : meshes.meshes) {
                for (std::size_t v = 0; mesh.vertices && v < mesh.vertices->size(); ++v) {
                    ASSERT_TRUE(finite((*mesh.vertices)[v].position) && finite((*mesh.vertices)[v].normal));
                }
            }
        });
    };
    show();
    for (const ecs::Entity holder : world.query<ecs::With<AnimationSet>>().entities()) {
        const AnimationSet set = world.get<AnimationSet>(holder);
        world.add(holder, AnimationPlayer{});
        for (std::uint32_t clip = 0; clip < set.clips->size(); ++clip) {
            play(world.get_mut<AnimationPlayer>(holder), set, clip);
            show();
            show();
        }
    }
}

}  // namespace lanthorn
