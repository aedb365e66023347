// Scenes as new documents: what is imported again is what was written.
#include <gtest/gtest.h>

#include <fstream>

#include "lanthorn/assets/gltf_document.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "tests/unit/assets/gltf_builder.h"
#include "tests/unit/assets/same_scene.h"

namespace lanthorn {
namespace {

SceneData through_a_file(const SceneData& scene) {
    const TemporaryFolder folder;
    return import_gltf(folder.write("a.glb", GltfDocument::of_scene(scene, "test").glb_bytes()));
}

// Every field of a scene, at values that are not its defaults.
SceneData everything() {
    SceneData scene;
    scene.images = {{"opaque", 2, 1, {1, 2, 3, 255, 4, 5, 6, 255}}, {"clear", 1, 1, {9, 8, 7, 128}}};
    scene.textures = {
        {0, {Wrap::clamp_to_edge, Wrap::mirrored_repeat, Filter::nearest, Filter::nearest, false}}, {1, {}}};
    Material m;
    m.name = "glass \xc3\xa4";
    m.base_colour = {0.1f, 0.2f, 0.3f, 0.4f};
    m.metallic = 0.25f;
    m.roughness = 0.75f;
    m.emissive = {17, 12, 4};
    m.normal_scale = 0.5f;
    m.occlusion_strength = 0.25f;
    m.alpha_mode = AlphaMode::mask;
    m.alpha_cutoff = 0.3f;
    m.double_sided = true;
    m.ior = 1.33f;
    m.specular = 0.9f;
    m.specular_colour = {1, 2, 0.5f};
    m.transmission = 0.8f;
    for (TextureRef* ref :
         {&m.base_colour_texture, &m.normal_texture, &m.emissive_texture, &m.specular_texture}) {
        ref->texture = 0;
    }
    for (TextureRef* ref : {&m.metallic_roughness_texture, &m.occlusion_texture, &m.specular_colour_texture,
                            &m.transmission_texture}) {
        ref->texture = 1;
        ref->uv_set = 1;
    }
    m.emissive_texture.uv_transform = {vec3(2, 0, 0.5f), vec3(0, 4, 0.25f)};
    Material plain;
    plain.unlit = true;
    plain.alpha_mode = AlphaMode::blend;
    plain.base_colour.a = 0.5f;
    scene.materials = {m, plain};

    Mesh mesh;
    mesh.name = "sheet";
    for (int i = 0; i < 4; ++i) {
        Vertex v;
        v.position = {i % 2, i / 2, 0.1f};
        v.tangent = {0, 1, 0, -1};
        v.uv0 = {0.5f, 0.25f * i};
        v.uv1 = {0.125f * i, 1};
        v.colour = {1, 0.5f, 0.25f, 1};
        mesh.vertices.push_back(v);
        mesh.bounds.add(v.position);
    }
    mesh.indices = {0, 1, 2, 2, 1, 3};
    mesh.morphs.resize(1);
    mesh.morphs[0].vertices = {1, 3};
    mesh.morphs[0].positions = {{0, 0, 1}, {0, 0.5f, 1}};
    mesh.morphs[0].normals = {{0.5f, 0, 0}, {0, 0.5f, 0}};
    mesh.morph_weights = {0.25f};
    SkinInfluences influences;
    influences.joints = {0, 1, 0, 0, 0, 0, 0, 0};
    influences.weights = {0.75f, 0.25f};
    mesh.skin.assign(4, influences);
    Mesh cage;
    cage.name = "sheet";
    cage.material = 1;
    cage.vertices = {mesh.vertices[0], mesh.vertices[1], mesh.vertices[2], mesh.vertices[3]};
    for (Vertex& v : cage.vertices) {
        v.uv0 = v.uv1 = vec2(0);
        v.tangent = {1, 0, 0, 1};
    }
    cage.indices = {0, 1, 3, 0, 3, 2};
    cage.bounds = mesh.bounds;
    cage.cage = SubdivisionCage{SubdivisionScheme::catmull_clark, 2, {4}, {{0, 1, 2.5f}}};
    scene.meshes = {mesh, cage};

    Camera wide;
    wide.y_fov = 0.7f;
    wide.z_near = 0.1f;
    wide.z_far = 50;
    Camera flat;
    flat.orthographic = true;
    flat.x_mag = 2;
    flat.y_mag = 3;
    flat.z_far = 20;
    scene.cameras = {wide, flat};
    Light sun{LightType::directional, {1, 0.9f, 0.8f}, 1000};
    Light point{LightType::point, vec3(1), 5, 12};
    Light spot{LightType::spot, vec3(1), 5, std::numeric_limits<float>::infinity(), 0.25f, 0.5f};
    scene.lights = {sun, point, spot};

    const auto node = [&](const char* name, std::uint32_t parent) -> NodeData& {
        NodeData& added = scene.nodes.emplace_back();
        added.name = name;
        added.parent = parent;
        return added;
    };
    node("root", kNone).local = {{1e6 + 0.1, -2, 3}, quat(0.5f, 0.5f, 0.5f, 0.5f), {1, 2, -3}};
    node("joint", 0).light = 0;
    node("joint 2", 1).light = 1;
    NodeData& skinned = node("skinned", 0);
    skinned.meshes = {0};
    skinned.skin = 0;
    skinned.morph_weights = {0.5f};
    skinned.extras = R"({"door":{"open":1.9}})";
    node("cage", kNone).meshes = {1};
    node("wide", 4).camera = 0;
    node("flat", 4).camera = 1;
    node("spot", kNone).light = 2;
    Skin skin;
    skin.name = "bones";
    skin.joints = {1, 2};
    skin.inverse_binds = {mat4(1), mat4(2)};
    skin.inverse_binds[1][3][3] = 1;
    scene.skins = {skin};
    AnimationChannel turn{1,      AnimationPath::rotation, Interpolation::linear, 4,
                          {0, 1}, {0, 0, 0, 1, 0, 1, 0, 0}};
    AnimationChannel step{3, AnimationPath::weights, Interpolation::step, 1, {0, 2}, {0, 1}};
    AnimationChannel curve{2,      AnimationPath::translation, Interpolation::cubic_spline, 3,
                           {0.5f}, {0, 0, 0, 1, 2, 3, 0, 0, 0}};
    scene.animations = {{"walk", 2, {turn, step, curve}, {}}};
    return scene;
}

TEST(DocumentOfScene, ComesBackInEveryField) {
    const SceneData scene = everything();
    const SceneData back = through_a_file(scene);
    EXPECT_TRUE(back.warnings.empty()) << testing::PrintToString(back.warnings);
    SceneData expected = scene;
    expected.materials[1].alpha_mode = AlphaMode::blend;
    expect_same_scene(back, expected);
}

TEST(DocumentOfScene, ShearAndTurnedTexturesComeBack) {
    SceneData scene;
    scene.images = {{"i", 1, 1, {1, 2, 3, 255}}};
    scene.textures = {{0, {}}};
    scene.materials.resize(1);
    TextureRef& ref = scene.materials[0].base_colour_texture;
    ref.texture = 0;
    ref.uv_transform = {vec3(2 * std::cos(0.3f), 3 * std::sin(0.3f), 0.5f),
                        vec3(-2 * std::sin(0.3f), 3 * std::cos(0.3f), 0)};
    scene.nodes.resize(1);
    scene.nodes[0].local.scale = {1, 2, 3};
    scene.nodes[0].shear[1][0] = 0.5f;
    const SceneData back = through_a_file(scene);
    for (int row = 0; row < 2; ++row) {
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(back.materials[0].base_colour_texture.uv_transform[static_cast<std::size_t>(row)][i],
                        ref.uv_transform[static_cast<std::size_t>(row)][i], 1e-6f);
        }
    }
    EXPECT_NEAR(back.nodes[0].shear[1][0], 0.5f, 1e-6f);
    EXPECT_NEAR(back.nodes[0].local.scale.z, 3, 1e-6f);
}

TEST(DocumentOfScene, TheSameSceneIsTheSameBytes) {
    EXPECT_EQ(GltfDocument::of_scene(everything(), "test").glb_bytes(),
              GltfDocument::of_scene(everything(), "test").glb_bytes());
}

TEST(DocumentOfScene, WhatGltfCannotHoldIsRefused) {
    SceneData scene = everything();
    scene.meshes[0].vertices[0].position.x = std::numeric_limits<float>::infinity();
    EXPECT_THROW(GltfDocument::of_scene(scene, "test"), InputError);
    scene = everything();
    scene.meshes[0].indices[0] = 4;
    EXPECT_THROW(GltfDocument::of_scene(scene, "test"), InputError);
    scene = everything();
    scene.nodes[0].name = "\xff";
    EXPECT_THROW(GltfDocument::of_scene(scene, "test"), InputError);
    scene = everything();
    scene.nodes[3].extras = "{";
    EXPECT_THROW(GltfDocument::of_scene(scene, "test"), InputError);
}

}  // namespace
}  // namespace lanthorn
