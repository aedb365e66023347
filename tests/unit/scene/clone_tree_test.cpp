#include "lanthorn/scene/clone_tree.h"

#include <gtest/gtest.h>

#include "engine/scene/declare_components.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/hierarchy.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn {
namespace {

TEST(CloneTree, CopiesWhatIsBelowWithItsReferences) {
    ecs::Registry registry;
    declare_scene_components(registry);
    ecs::World world;
    SceneData scene;
    scene.nodes.resize(4);
    scene.nodes[1].parent = 0;
    scene.nodes[2].parent = 1;
    scene.nodes[1].name = "arm";
    scene.nodes[2].local.translation = dvec3(1, 2, 3);
    scene.nodes[1].local.translation = dvec3(0, 1, 0);
    const std::vector<ecs::Entity> nodes = spawn(world, scene);
    world.add(nodes[2], SkinInstance{{nodes[1], nodes[0]}, {mat4(1), mat4(1)}});

    const std::vector<ecs::Entity> copies = clone_tree(world, registry, nodes[1]);
    ASSERT_EQ(copies.size(), 2u);
    EXPECT_EQ(world.get<Name>(copies[0]).value, "arm");
    EXPECT_EQ(world.get<Parent>(copies[0]).entity, nodes[0]);
    EXPECT_EQ(world.get<Parent>(copies[1]).entity, copies[0]);
    EXPECT_EQ(world.get<SkinInstance>(copies[1]).joints, (std::vector<ecs::Entity>{copies[0], nodes[0]}));
    EXPECT_EQ(children_of(world, nodes[0]).size(), 2u);
    ASSERT_EQ(children_of(world, copies[0]).size(), 1u);
    EXPECT_EQ(children_of(world, copies[0])[0], copies[1]);
    world.get_mut<LocalTransform>(copies[0]).value.translation.x = 5;
    Transforms().update(world);
    EXPECT_EQ(dvec3(world.get<WorldTransform>(copies[1]).matrix[3]), dvec3(6, 3, 3));
    EXPECT_EQ(dvec3(world.get<WorldTransform>(nodes[2]).matrix[3]), dvec3(1, 3, 3));
    EXPECT_THROW(clone_tree(world, registry, ecs::Entity{999, 1}), ecs::Error);
}

}  // namespace
}  // namespace lanthorn
