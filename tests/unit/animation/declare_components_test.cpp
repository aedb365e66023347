#include "engine/animation/declare_components.h"

#include <gtest/gtest.h>

#include "lanthorn/animation/animation_player.h"
#include "lanthorn/ecs/component_json.h"

namespace lanthorn {
namespace {

TEST(DeclareAnimationComponents, LayersAreStateAndTheBindingIsNot) {
    ecs::Registry registry;
    declare_animation_components(registry);
    ecs::World world;
    AnimationPlayer player;
    player.layers.emplace_back();
    const ecs::Entity e = world.create(player);
    EXPECT_EQ(ecs::get_json(registry, world, e, "animation_player.root.turn"), "[0.0,0.0,0.0,1.0]");
    const ecs::ComponentType& type = *registry.find<AnimationPlayer>();
    ASSERT_EQ(type.value->fields.size(), 4u);
    EXPECT_FALSE(type.value->fields[0].transient);
    EXPECT_TRUE(type.value->fields[3].transient);
}

}  // namespace
}  // namespace lanthorn
