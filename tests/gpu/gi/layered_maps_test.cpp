// Maps that pay for change alone show what maps drawn anew show.
#include "gi_module/techniques/emc/maps/layered_maps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace layered_maps_test {

constexpr int kResolution = 32;
const std::vector<vec3> kCentres{vec3(1, 1, 1.5f), vec3(3, 1.5f, 0.7f), vec3(2, 2, 2.6f)};

// A room, a pillar in it, and a block that moves along x.
FrameScene room(const Mesh& mover = box(vec3(-0.2f), vec3(0.2f), false, 1)) {
    FrameScene scene = scene_of(
        {box(vec3(0), vec3(4, 2.6f, 3), true, 0), box(vec3(2.8f, 0, 2), vec3(3, 2, 2.2f), false, 1), mover},
        {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))}, {point_light(vec3(2), 100)},
        vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
    return scene;
}

void place_block(FrameScene& scene, float x) {
    Instance& block = scene.instances[2];
    block.transform[3] = vec4(x, 0.5f, 1.2f, 1);
    block.bounds = transformed(scene.assets->meshes[2].bounds, block.transform);
    block.is_static = false;
    ++scene.frame;
}

struct Maps {
    Maps() : layered(MapUse::coverage, static_cast<int>(kCentres.size()), kResolution) {
        for (int i = 0; i < static_cast<int>(kCentres.size()); ++i) {
            layered.place(i, kCentres[static_cast<std::size_t>(i)]);
            slots.push_back(i);
        }
    }
    std::vector<float> show(const FrameScene& scene) {
        gpu_scene.update(scene);
        layered.update(scene, gpu_scene, slots);
        return layered.maps().planes().read_floats(4);
    }
    const bool software = context().info().software;  // first: the rest needs a current context
    render::GpuScene gpu_scene;
    LayeredMaps layered;
    std::vector<int> slots;
};

std::vector<float> drawn_anew(const FrameScene& scene) {
    return Maps().show(scene);
}

TEST(LayeredMaps, AMoverIsDrawnOverWhatStandsStill) {
    FrameScene scene = room();
    place_block(scene, 1);
    Maps maps;
    EXPECT_EQ(maps.show(scene), drawn_anew(scene));
    EXPECT_EQ(maps.layered.faces_touched(), 18);
    for (const float x : {1.3f, 2.0f, 3.5f}) {
        place_block(scene, x);
        EXPECT_EQ(maps.show(scene), drawn_anew(scene)) << x;
        EXPECT_GT(maps.layered.faces_touched(), 0);
        EXPECT_LT(maps.layered.faces_touched(), 18) << "only faces that see the block, now or before";
    }
    // It comes to rest: drawn into what stands still, and nothing is to be done from there on.
    scene.instances[2].is_static = true;
    ++scene.frame;
    EXPECT_EQ(maps.show(scene), drawn_anew(scene));
    EXPECT_EQ(maps.show(scene), drawn_anew(scene));
    EXPECT_EQ(maps.layered.faces_touched(), 0);
}

TEST(LayeredMaps, WhatLeavesOrComesIsSeen) {
    FrameScene scene = room();
    place_block(scene, 1);
    Maps maps;
    maps.show(scene);
    FrameScene without = scene;
    without.instances.erase(without.instances.begin() + 1);
    ++without.frame;
    EXPECT_EQ(maps.show(without), drawn_anew(without));
    scene.frame = without.frame + 1;
    EXPECT_EQ(maps.show(scene), drawn_anew(scene));
}

// Slots that take turns see what moved while it was not theirs.
TEST(LayeredMaps, SlotsOfDifferentLooksTakeTurns) {
    FrameScene scene = room();
    Maps maps;
    maps.gpu_scene.update(scene);
    for (int turn = 0; turn < 9; ++turn) {
        place_block(scene, 0.6f + 0.3f * static_cast<float>(turn));
        maps.gpu_scene.update(scene);
        const int slot = turn % 3;
        maps.layered.update(scene, maps.gpu_scene, {slot}, slot);
        const auto size = static_cast<std::ptrdiff_t>(6 * kResolution * kResolution * 4);
        const auto here = maps.layered.maps().planes().read_floats(4);
        const auto anew = drawn_anew(scene);
        EXPECT_TRUE(std::equal(here.begin() + slot * size, here.begin() + (slot + 1) * size,
                               anew.begin() + slot * size))
            << turn;
        EXPECT_EQ(maps.layered.faces_touched() == 6, turn < 3) << turn << ": drawn anew once";
    }
    // A look at all of them does not know what those of other looks show.
    EXPECT_EQ(maps.show(scene), drawn_anew(scene));
    EXPECT_GE(maps.layered.faces_touched(), 12) << "those that were of looks 1 and 2";
}

TEST(LayeredMaps, AnotherCentreIsDrawnAnew) {
    const FrameScene scene = room();
    Maps maps;
    maps.show(scene);
    maps.layered.place(1, vec3(0.5f, 0.5f, 0.5f));
    const auto moved = maps.show(scene);
    EXPECT_EQ(maps.layered.faces_touched(), 6);
    Maps fresh;
    fresh.layered.place(1, vec3(0.5f, 0.5f, 0.5f));
    EXPECT_EQ(moved, fresh.show(scene));
}

// What bends is drawn as coarsely as a map's texels allow: few triangles, within a texel of what all show.
TEST(LayeredMaps, MoversAreDrawnCoarsely) {
    const FrameScene scene = room(support::sphere(vec3(0), 0.3f, 5, false, 1));
    const auto show = [&](bool levels, GLuint& triangles) {
        FrameScene now = scene;
        Maps maps;
        maps.gpu_scene.use_levels(levels);
        deform_instance(now, 2, 77, [](const vec3& p) { return p * vec3(1, 1.3f, 1); });
        maps.show(now);
        place_block(now, 1);
        deform_instance(now, 2, 77, [](const vec3& p) { return p * vec3(1, 1.2f, 1); });
        GLuint query = 0;
        glGenQueries(1, &query);
        glBeginQuery(GL_PRIMITIVES_GENERATED, query);
        std::vector<float> shown = maps.show(now);
        glEndQuery(GL_PRIMITIVES_GENERATED);
        glGetQueryObjectuiv(query, GL_QUERY_RESULT, &triangles);
        glDeleteQueries(1, &query);
        return shown;
    };
    GLuint few = 0, all = 0;
    const std::vector<float> coarse = show(true, few), full = show(false, all);
    EXPECT_GT(few, 0u);
    EXPECT_LT(few, all / 4);
    // Distances: the same but at the rim, where the texel beside shows the wall.
    std::size_t differ = 0;
    for (std::size_t t = 3; t < full.size(); t += 4) {
        differ += std::abs(coarse[t] - full[t]) > 2.0f / kResolution * std::abs(full[t]) ? 1 : 0;
    }
    EXPECT_LT(differ, full.size() / 4 / 200);
}

}  // namespace layered_maps_test
}  // namespace lanthorn::gi::test
