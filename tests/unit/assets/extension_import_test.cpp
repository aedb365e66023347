// Extensions that say in other words what the format says, and those that nobody reads.
#include "engine/assets/gltf_material_layers.h"
#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;

class ExtensionImport : public ImportTest {
  protected:
    SceneData import_material(const json& material) {
        builder.add_triangle()["material"] = builder.add_material(material);
        return import();
    }
};

TEST_F(ExtensionImport, WhatIsNotReadIsToldOnce) {
    builder.json["extensionsUsed"] = {"ACME_one", "KHR_materials_ior", "KHR_materials_iridescence"};
    expect_warning(import_material(json::object()), "/extensionsUsed",
                   "ACME_one, KHR_materials_iridescence are not read; what they add is left out");
}

TEST_F(ExtensionImport, RequiredLooksMayBeMissing) {
    builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {"KHR_materials_iridescence"};
    expect_warning(import_material(json::object()), "/extensionsUsed",
                   "KHR_materials_iridescence is not read");
}

TEST_F(ExtensionImport, KtxTexturesAreToldOnceWithTheWayOut) {
    builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {"KHR_texture_basisu"};
    for (int i = 0; i < 3; ++i) {
        builder.json["images"].push_back({{"uri", "none.ktx2"}});
        builder.json["textures"].push_back({{"extensions", {{"KHR_texture_basisu", {{"source", i}}}}}});
    }
    const SceneData scene =
        import_material({{"emissiveTexture", {{"index", 0}}}, {"normalTexture", {{"index", 1}}}});
    expect_warning(scene, "/extensionsUsed", "gltf-transform ktxdecompress");
}

TEST_F(ExtensionImport, WebpTextures) {
    builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {"EXT_texture_webp"};
    builder.json["images"] = {
        {{"bufferView", builder.add_view(make_webp(2, 1, {9, 9, 9, 9, 9, 9}))}, {"mimeType", "image/webp"}}};
    builder.json["textures"] = {{{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}}};
    const SceneData scene = import_material({{"emissiveTexture", {{"index", 0}}}});
    EXPECT_TRUE(scene.warnings.empty()) << testing::PrintToString(scene.warnings);
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].width, 2u);
    EXPECT_TRUE(scene.materials[0].emissive_texture.present());
}

// --- KHR_materials_variants ---

class Variants : public ExtensionImport {
  protected:
    void SetUp() override {
        json& primitive = builder.add_triangle();
        primitive["material"] = builder.add_material({{"name", "plain"}});
        const int red = builder.add_material({{"name", "red"}});
        primitive["extensions"]["KHR_materials_variants"]["mappings"] = {
            {{"material", red}, {"variants", {1, 2}}}, {{"material", 0}, {"variants", {0}}}};
        builder.json["extensions"]["KHR_materials_variants"]["variants"] = {
            {{"name", "Day"}}, {{"name", "Dusk"}}, {{"name", "Night"}}};
    }
    std::string material_of(const std::string& variant) {
        const SceneData scene = import_gltf(folder.write("scene.gltf", builder.gltf()), {variant, false});
        return scene.materials[scene.meshes.at(0).material].name;
    }
};

TEST_F(Variants, ChooseMaterials) {
    EXPECT_EQ(material_of(""), "plain");
    EXPECT_EQ(material_of("Day"), "plain");
    EXPECT_EQ(material_of("Night"), "red");
    try {
        material_of("Noon");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("no variant 'Noon', expected one of: Day, Dusk, Night"),
                  std::string::npos)
            << error.what();
    }
}

TEST_F(Variants, BrokenReferencesAreRefused) {
    json& mapping =
        builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"][0];
    mapping["variants"] = {3};
    expect_refused("/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings/0/variants", "below 3");
    mapping["variants"] = {0};
    mapping["material"] = 9;
    expect_refused("/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings/0/material");
}

// --- KHR_node_visibility ---

TEST_F(ExtensionImport, NodesThatAreNotVisibleShowNothing) {
    builder.add_triangle();
    builder.add_triangle();
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    builder.json["nodes"][0]["extensions"]["KHR_node_visibility"] = {{"visible", false}};
    builder.json["nodes"][0]["children"] = {2};
    builder.json["nodes"].push_back(
        {{"name", "under"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty()) << testing::PrintToString(scene.warnings);
    ASSERT_EQ(scene.nodes.size(), 3u);
    EXPECT_TRUE(scene.nodes[0].meshes.empty());
    EXPECT_EQ(scene.nodes[1].name, "under");
    EXPECT_EQ(scene.nodes[1].light, kNone);
    EXPECT_EQ(scene.nodes[2].meshes.size(), 1u);
    EXPECT_EQ(scene.meshes.size(), 1u);
}

// --- EXT_mesh_gpu_instancing ---

class Instancing : public ExtensionImport {
  protected:
    void SetUp() override {
        builder.add_triangle();
        node()["name"] = "tree";
        node()["translation"] = {0, 5, 0};
    }
    json& node() { return builder.json["nodes"][0]; }
    json& attributes() { return node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]; }
};

TEST_F(Instancing, AChildForEachInstance) {
    attributes()["TRANSLATION"] = builder.add_vec3({1, 0, 0, 2, 0, 0});
    attributes()["SCALE"] = builder.add_vec3({1, 1, 1, 3, 3, 3});
    // A quarter turn about Y, as normalised bytes, and none.
    attributes()["ROTATION"] = builder.add(std::vector<std::int8_t>{0, 90, 0, 90, 0, 0, 0, 127}, "VEC4", 4);
    builder.json["accessors"].back()["normalized"] = true;
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty()) << testing::PrintToString(scene.warnings);
    ASSERT_EQ(scene.nodes.size(), 3u);
    EXPECT_TRUE(scene.nodes[0].meshes.empty());
    EXPECT_EQ(scene.nodes[2].name, "tree/1");
    EXPECT_EQ(scene.nodes[2].parent, 0u);
    EXPECT_EQ(scene.nodes[2].local.translation, dvec3(2, 0, 0));
    EXPECT_EQ(scene.nodes[2].local.scale, vec3(3));
    expect_near(scene.nodes[1].local.rotation * vec3(1, 0, 0), vec3(0, 0, -1));
    EXPECT_EQ(scene.nodes[1].meshes, scene.nodes[2].meshes);
}

TEST_F(Instancing, UnusableInstancesAreLeftOut) {
    attributes()["TRANSLATION"] = builder.add_vec3({1, 0, 0, NAN, 0, 0});
    const SceneData scene = import();
    expect_warning(scene, "/nodes/0/extensions/EXT_mesh_gpu_instancing",
                   "1 instances have transforms that are not finite");
    EXPECT_EQ(scene.nodes.size(), 2u);
}

TEST_F(Instancing, CountsMustAgree) {
    attributes()["TRANSLATION"] = builder.add_vec3({1, 0, 0, 2, 0, 0});
    attributes()["SCALE"] = builder.add_vec3({1, 1, 1});
    expect_refused("/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/SCALE",
                   "has 1 elements, expected 2");
}

TEST_F(Instancing, MoreThanTheBudgetAreLeftOut) {
    attributes()["TRANSLATION"] = builder.add_accessor(-1, 5126, "VEC3", 200007);
    const SceneData scene = import();
    ASSERT_FALSE(scene.warnings.empty());
    EXPECT_NE(scene.warnings[0].find(
                  "/nodes: 7 placements of primitives are left out: nodes and instances show more"),
              std::string::npos)
        << scene.warnings[0];
}

// --- KHR_animation_pointer ---

TEST_F(ExtensionImport, PointersToNodesMoveThem) {
    builder.add_triangle();
    const int times = builder.add_scalars<float>({0, 1}), values = builder.add_vec3({0, 0, 0, 1, 2, 3});
    const auto pointing = [](const std::string& at) {
        return json{{"sampler", 0},
                    {"target",
                     {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", at}}}}}}}};
    };
    builder.json["animations"] = {
        {{"samplers", {{{"input", times}, {"output", values}}}},
         {"channels", {pointing("/nodes/0/translation"), pointing("/materials/0/name")}}}};
    const SceneData scene = import();
    expect_warning(scene, "/animations/0/channels/1/target/path", "'/materials/0/name' is not animated here");
    ASSERT_EQ(scene.animations.size(), 1u);
    ASSERT_EQ(scene.animations[0].channels.size(), 1u);
    EXPECT_EQ(scene.animations[0].channels[0].path, AnimationPath::translation);
}

// --- materials ---

float f0(const Material& m, int channel) {
    const float r = (m.ior - 1) / (m.ior + 1);
    return std::min(r * r * m.specular_colour[channel], 1.0f) * m.specular;
}

TEST_F(ExtensionImport, SpecularGlossinessReflectsTheSame) {
    const SceneData scene = import_material({{"extensions",
                                              {{"KHR_materials_pbrSpecularGlossiness",
                                                {{"diffuseFactor", {0.8, 0.1, 0.1, 0.5}},
                                                 {"specularFactor", {0.9, 0.6, 0.2}},
                                                 {"glossinessFactor", 0.75}}}}}});
    EXPECT_TRUE(scene.warnings.empty()) << testing::PrintToString(scene.warnings);
    const Material& m = scene.materials.at(0);
    EXPECT_EQ(m.base_colour, vec4(0.8f, 0.1f, 0.1f, 0.5f));
    EXPECT_EQ(m.metallic, 0);
    EXPECT_NEAR(m.roughness, 0.25f, 1e-6f);
    for (const auto& [channel, expected] : {std::pair(0, 0.9f), std::pair(1, 0.6f), std::pair(2, 0.2f)}) {
        EXPECT_NEAR(f0(m, channel), expected, 1e-4f);
    }
}

TEST_F(ExtensionImport, GlossinessIsReadFromAlpha) {
    const int texture = builder.add_texture(make_png(1, 1, {200, 100, 50, 204}, 4));
    const SceneData scene =
        import_material({{"extensions",
                          {{"KHR_materials_pbrSpecularGlossiness",
                            {{"glossinessFactor", 0.5},
                             {"specularGlossinessTexture", {{"index", texture}, {"texCoord", 1}}}}}}}});
    EXPECT_TRUE(scene.warnings.empty()) << testing::PrintToString(scene.warnings);
    const Material& m = scene.materials.at(0);
    const auto texel = [&](const TextureRef& ref) {
        return scene.images[scene.textures[ref.texture].image].rgba;
    };
    EXPECT_EQ(texel(m.specular_colour_texture), (std::vector<std::uint8_t>{200, 100, 50, 204}));
    EXPECT_EQ(texel(m.metallic_roughness_texture), (std::vector<std::uint8_t>{0, 153, 0, 255}));
    EXPECT_EQ(m.metallic_roughness_texture.uv_set, 1u);
    EXPECT_EQ(m.roughness, 1);
}

TEST_F(ExtensionImport, MaterialsShareWhatBecomesOfGlossiness) {
    const int texture = builder.add_texture(make_png(1, 1, {200, 100, 50, 204}, 4));
    const auto material = [&](double factor) {
        return json{
            {"extensions",
             {{"KHR_materials_pbrSpecularGlossiness",
               {{"glossinessFactor", factor}, {"specularGlossinessTexture", {{"index", texture}}}}}}}};
    };
    for (int i = 0; i < 20; ++i) {
        builder.add_material(material(0.5));
    }
    const SceneData scene = import_material(material(0.25));
    EXPECT_EQ(scene.images.size(), 3u) << "the colour, and one for each factor";
    EXPECT_EQ(scene.textures.size(), 3u);
    EXPECT_EQ(scene.materials[0].metallic_roughness_texture, scene.materials[19].metallic_roughness_texture);
    EXPECT_NE(scene.materials[0].metallic_roughness_texture, scene.materials[20].metallic_roughness_texture);
}

TEST_F(ExtensionImport, NoMemberOfAnImageMakesItGlossiness) {
    const int texture = builder.add_texture(make_png(1, 1, {200, 100, 50, 204}, 4));
    builder.json["images"][0]["lanthorn.glossiness"] = 0.5;
    builder.json["images"][0]["extras"]["lanthorn.glossiness"] = 0.5;
    const SceneData scene = import_material({{"emissiveTexture", {{"index", texture}}}});
    EXPECT_EQ(scene.images.at(0).rgba, (std::vector<std::uint8_t>{200, 100, 50, 204}));
}

TEST_F(ExtensionImport, AClearCoatReflectsAndDims) {
    const SceneData scene = import_material(
        {{"pbrMetallicRoughness", {{"metallicFactor", 0}}},
         {"extensions",
          {{"KHR_materials_clearcoat", {{"clearcoatFactor", 1}, {"clearcoatRoughnessFactor", 0.1}}}}}});
    expect_warning(scene, "/materials/0/extensions/KHR_materials_clearcoat", "no highlight of its own");
    const Material& m = scene.materials.at(0);
    EXPECT_NEAR(f0(m, 0), 0.04f + 0.96f * 0.04f, 1e-5f);
    EXPECT_LT(m.base_colour.x, 0.9f);
    EXPECT_GT(m.base_colour.x, 0.8f);
}

TEST_F(ExtensionImport, SheenAddsWhatItTakesFromBelow) {
    EXPECT_GT(sheen_albedo(1), sheen_albedo(0.3f));
    EXPECT_LT(sheen_albedo(1), 0.5f);
    const SceneData scene = import_material(
        {{"pbrMetallicRoughness", {{"baseColorFactor", {0, 1, 0, 1}}}},
         {"extensions",
          {{"KHR_materials_sheen", {{"sheenColorFactor", {1, 0, 0}}, {"sheenRoughnessFactor", 1}}}}}});
    expect_warning(scene, "/materials/0/extensions/KHR_materials_sheen", "the sheen has no angle");
    const vec4 colour = scene.materials.at(0).base_colour;
    EXPECT_NEAR(colour.x, sheen_albedo(1), 1e-5f);
    EXPECT_NEAR(colour.x + colour.y, 1, 1e-5f);
}

}  // namespace
}  // namespace lanthorn
