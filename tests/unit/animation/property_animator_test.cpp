// Clips that move lights, cameras and materials.
#include "engine/animation/property_animator.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/animation/channels.h"

namespace animation_test {
namespace {

using enum AnimatedProperty;

// From the first value to the last in two seconds.
PropertyChannel sliding(AnimatedProperty property, std::vector<float> values, const PropertyValue& rest,
                        std::vector<std::uint32_t> nodes = {}) {
    PropertyChannel c;
    c.property = property;
    c.nodes = std::move(nodes);
    c.rest = rest;
    c.keys = channel(AnimationPath::weights, Interpolation::linear, {0, 2}, std::move(values));
    c.keys.width = width_of(property);
    return c;
}

AnimationClip moving(std::vector<PropertyChannel> properties) {
    AnimationClip c;
    c.duration = 2;
    c.properties = std::move(properties);
    return c;
}

// Two nodes with the same light of 10 cd, a camera, and a material.
struct Stage {
    explicit Stage(std::vector<AnimationClip> clips) {
        SceneData scene;
        scene.nodes.resize(3);
        scene.nodes[0].light = scene.nodes[1].light = 0;
        scene.nodes[2].camera = 0;
        scene.lights.resize(1);
        scene.lights[0].intensity = 10;
        scene.cameras.resize(1);
        scene.materials.resize(1);
        scene.materials[0].emissive = vec3(4, 2, 0);
        scene.animations = std::move(clips);
        handle = asset_store(world).add(std::move(scene));
        nodes = spawn(world, handle);
        holder = world.query<ecs::With<AnimationSet>>().single_entity();
        world.add(holder, AnimationPlayer{});
    }
    void add_layer(std::uint32_t clip, double time, double weight = 1) {
        AnimationLayer layer;
        layer.clip = clip;
        layer.time = time;
        layer.weight = weight;
        world.get_mut<AnimationPlayer>(holder).layers.push_back(layer);
    }
    void animate(double back = 0, const PropertyAnimator::Overwritten* overwritten = nullptr) {
        ecs::KeptQuery<ecs::Read<AnimationPlayer>, ecs::Read<AnimationSet>, ecs::Read<Source>> players;
        animator.animate(players.in(world), PropertyAnimator::Lamps(world), asset_store(world), back, 0,
                         overwritten);
    }
    const Light& light(std::size_t node = 0) { return world.get<LightComponent>(nodes[node]).light; }
    const Camera& camera() { return world.get<CameraComponent>(nodes[2]).camera; }
    const Material& material() {
        return asset_store(world).get(asset_store(world).get(handle).materials.at(0));
    }

    ecs::World world;
    SceneHandle handle;
    std::vector<ecs::Entity> nodes;
    ecs::Entity holder;
    PropertyAnimator animator;
};

TEST(PropertyAnimator, MovesEveryNodeThatShowsTheLight) {
    Stage stage({moving({sliding(light_intensity, {0, 100}, {10}, {0, 1})})});
    stage.add_layer(0, 0.5);
    stage.animate();
    EXPECT_EQ(stage.light(0).intensity, 25);
    EXPECT_EQ(stage.light(1).intensity, 25);
    EXPECT_EQ(stage.light(0).colour, vec3(1)) << "nothing else";
}

TEST(PropertyAnimator, WhatIsMissingToOneIsWhatTheFileSays) {
    const AnimationClip bright = moving({sliding(light_intensity, {100, 100}, {10}, {0})});
    const AnimationClip other = moving({sliding(camera_y_fov, {0.5, 0.5}, {1}, {2})});
    Stage stage({bright, other});
    stage.add_layer(0, 0, 0.25);
    stage.animate();
    EXPECT_EQ(stage.light().intensity, 0.25f * 100 + 0.75f * 10);
    stage.add_layer(1, 0, 0.25);  // does not move the light
    stage.animate();
    EXPECT_EQ(stage.light().intensity, 0.25f * 100 + 0.75f * 10);
    EXPECT_EQ(stage.camera().y_fov, 0.25f * 0.5f + 0.75f * 1);
    stage.add_layer(0, 0, 3.5);  // four in all: each counts a quarter of its weight
    stage.animate();
    EXPECT_FLOAT_EQ(stage.light().intensity, (3.75f * 100 + 0.25f * 10) / 4);
}

TEST(PropertyAnimator, AnInfiniteRangeIsNoPartOfAWholeLayer) {
    Stage stage({moving({sliding(light_range, {4, 4}, {std::numeric_limits<double>::infinity()}, {0})})});
    stage.add_layer(0, 1);
    stage.animate();
    EXPECT_EQ(stage.light().range, 4);
}

TEST(PropertyAnimator, ADistanceOfZeroIsInfinite) {
    Stage stage(
        {moving({sliding(camera_z_far, {4, 4}, {0}, {2}), sliding(attenuation_distance, {4, 4}, {0})})});
    stage.add_layer(0, 1, 0.5);
    stage.animate();
    EXPECT_EQ(stage.camera().z_far, 0);
    EXPECT_EQ(stage.material().attenuation_distance, 0);
    stage.add_layer(0, 1, 0.5);
    stage.animate();
    EXPECT_EQ(stage.camera().z_far, 4);
    EXPECT_EQ(stage.material().attenuation_distance, 4);
}

TEST(PropertyAnimator, AnIndexOfRefractionOfZeroReflectsAll) {
    Stage stage({moving({sliding(ior, {1.5, 0}, {1.5})})});
    stage.add_layer(0, 0.5);
    stage.animate();
    EXPECT_EQ(stage.material().ior, 1.125f);
    Stage end({moving({sliding(ior, {0, 0}, {1.5})})});
    end.add_layer(0, 1);
    end.animate();
    EXPECT_EQ(end.material().ior, 1000);
}

TEST(PropertyAnimator, MaterialsChangeForAllThatShowThem) {
    Stage stage({moving({sliding(roughness, {0, 1}, {1}), sliding(emissive, {1, 1, 1, 3, 1, 1}, {4, 2, 0}),
                         sliding(emissive_scale, {10, 10}, {1})})});
    const std::uint64_t before = asset_store(stage.world).assets().serial;
    stage.add_layer(0, 1);
    stage.animate();
    EXPECT_EQ(stage.material().roughness, 0.5f);
    EXPECT_EQ(stage.material().emissive, vec3(20, 10, 10));
    const std::uint64_t after = asset_store(stage.world).assets().serial;
    EXPECT_NE(after, before);
    stage.animate();
    EXPECT_EQ(asset_store(stage.world).assets().serial, after) << "what is the same is not written";
}

// A factor and a strength are multiplied before they are blended with what has emission as one.
TEST(PropertyAnimator, AStrengthIsItsOwnClips) {
    Stage stage(
        {moving({sliding(emissive, {1, 1, 1, 1, 1, 1}, {4, 2, 0}), sliding(emissive_scale, {0, 20}, {1})}),
         moving({sliding(emissive, {6, 0, 0, 6, 0, 0}, {4, 2, 0})})});
    stage.add_layer(0, 1, 0.25);
    stage.add_layer(1, 1, 0.25);
    stage.animate();
    EXPECT_EQ(stage.material().emissive, vec3(2.5 + 1.5 + 2, 2.5 + 1, 2.5));
}

TEST(PropertyAnimator, ValuesStayInTheirRange) {
    Stage stage(
        {moving({sliding(light_intensity, {-5, -5}, {10}, {0}), sliding(light_inner_cone, {2, 2}, {0}, {0}),
                 sliding(light_outer_cone, {0.5, 0.5}, {0.7}, {0}), sliding(camera_y_fov, {9, 9}, {1}, {2}),
                 sliding(camera_z_far, {0.01f, 0.01f}, {0}, {2}), sliding(metallic, {7, 7}, {1})})});
    stage.add_layer(0, 0);
    stage.animate();
    EXPECT_EQ(stage.light().intensity, 0);
    EXPECT_EQ(stage.light().outer_cone, 0.5f);
    EXPECT_LT(stage.light().inner_cone, stage.light().outer_cone);
    EXPECT_LT(stage.camera().y_fov, kPi);
    EXPECT_GT(stage.camera().z_far, stage.camera().z_near);
    EXPECT_EQ(stage.material().metallic, 1);
}

TEST(PropertyAnimator, TellsWhatItOverwritesForAPicture) {
    Stage stage({moving({sliding(light_intensity, {0, 100}, {10}, {0})})});
    stage.add_layer(0, 1);
    std::vector<float> told;
    const PropertyAnimator::Overwritten overwritten{[&](ecs::Entity, const Light& was, const Light& is) {
                                                        told = {was.intensity, is.intensity};
                                                    },
                                                    {}};
    stage.animate(0.5, &overwritten);
    EXPECT_EQ(told, (std::vector<float>{10, 25}));
    EXPECT_EQ(stage.light().intensity, 25);
}

}  // namespace
}  // namespace animation_test
