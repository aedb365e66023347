// KHR_animation_pointer: clips that move lights, cameras and materials.
#include <algorithm>

#include "lanthorn/assets/gltf_document.h"
#include "tests/unit/assets/import_fixture.h"
#include "tests/unit/assets/same_scene.h"

namespace lanthorn {
namespace {

using nlohmann::json;
using enum AnimatedProperty;

class PointerImport : public ImportTest {
  protected:
    void SetUp() override {
        builder.add_triangle()["material"] = builder.add_material(
            {{"emissiveFactor", {0.5, 0.25, 0}},
             {"pbrMetallicRoughness", {{"roughnessFactor", 0.75}}},
             {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}}});
        builder.json["extensionsUsed"] = {"KHR_animation_pointer", "KHR_lights_punctual",
                                          "KHR_materials_emissive_strength"};
        builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
            {{"type", "point"}, {"intensity", 7}}, {{"type", "spot"}, {"spot", {{"outerConeAngle", 0.5}}}}};
        builder.json["cameras"] = {
            {{"type", "perspective"}, {"perspective", {{"yfov", 0.75}, {"znear", 0.1}}}},
            {{"type", "orthographic"},
             {"orthographic", {{"xmag", 2}, {"ymag", 3}, {"znear", 0}, {"zfar", 9}}}}};
        builder.json["nodes"].push_back(lamp(1));
        builder.json["nodes"].push_back(lamp(1));
        builder.json["nodes"].push_back({{"camera", 0}});
        builder.json["nodes"].push_back({{"camera", 1}});
        times_ = builder.add_scalars<float>({0, 2});
        builder.json["animations"] = {{{"samplers", json::array()}, {"channels", json::array()}}};
    }
    static json lamp(int light) { return {{"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}}; }
    // `width` numbers a key, two keys.
    void point(const std::string& at, const std::vector<float>& values, int width) {
        const char* types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
        json& animation = builder.json["animations"][0];
        animation["channels"].push_back(
            {{"sampler", animation["samplers"].size()},
             {"target",
              {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", at}}}}}}}});
        animation["samplers"].push_back(
            {{"input", times_},
             {"output", builder.add(values, types[width], static_cast<std::size_t>(width))}});
    }
    const PropertyChannel& only(const SceneData& scene) {
        EXPECT_TRUE(scene.warnings.empty()) << testing::PrintToString(scene.warnings);
        return scene.animations.at(0).properties.at(0);
    }
    int times_ = 0;
};

TEST_F(PointerImport, LightsOfAllNodesThatShowThem) {
    point("/extensions/KHR_lights_punctual/lights/1/color", {1, 0, 0, 0, 1, 0}, 3);
    const SceneData scene = import();
    const PropertyChannel& channel = only(scene);
    EXPECT_EQ(channel.property, light_colour);
    EXPECT_EQ(channel.object, 1u);
    EXPECT_EQ(channel.nodes, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(channel.rest, (PropertyValue{1, 1, 1, 0}));
    EXPECT_EQ(channel.keys.width, 3u);
    EXPECT_EQ(channel.keys.values, (std::vector<float>{1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(scene.animations[0].duration, 2);
}

// Every pointer that is read, to a scene and back to a file.
TEST_F(PointerImport, AllComeBackAsTheyWere) {
    const std::string light = "/extensions/KHR_lights_punctual/lights/1/", material = "/materials/0/";
    const std::string extensions = material + "extensions/KHR_materials_";
    std::size_t count = 0;
    const auto add = [&](const std::string& at, int width) {
        std::vector<float> values;
        for (int i = 0; i < 2 * width; ++i) {
            values.push_back(0.25f + 0.0625f * static_cast<float>(i));
        }
        point(at, values, width);
        ++count;
    };
    add(light + "color", 3);
    for (const char* member : {"intensity", "range", "spot/innerConeAngle", "spot/outerConeAngle"}) {
        add(light + member, 1);
    }
    for (const char* member :
         {"0/perspective/yfov", "0/perspective/znear", "0/perspective/zfar", "1/orthographic/xmag",
          "1/orthographic/ymag", "1/orthographic/znear", "1/orthographic/zfar"}) {
        add(std::string("/cameras/") + member, 1);
    }
    add(material + "pbrMetallicRoughness/baseColorFactor", 4);
    add(material + "emissiveFactor", 3);
    add(extensions + "specular/specularColorFactor", 3);
    add(extensions + "volume/attenuationColor", 3);
    for (const std::string& at :
         {material + "pbrMetallicRoughness/metallicFactor", material + "pbrMetallicRoughness/roughnessFactor",
          material + "normalTexture/scale", material + "occlusionTexture/strength", material + "alphaCutoff",
          extensions + "ior/ior", extensions + "specular/specularFactor",
          extensions + "transmission/transmissionFactor", extensions + "volume/thicknessFactor",
          extensions + "volume/attenuationDistance"}) {
        add(at, 1);
    }
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty()) << testing::PrintToString(scene.warnings);
    ASSERT_EQ(scene.animations.size(), 1u);
    EXPECT_EQ(scene.animations[0].properties.size(), count);
    const SceneData again =
        import_gltf(folder.write("again.glb", GltfDocument::of_scene(scene, "test").glb_bytes()));
    EXPECT_TRUE(again.warnings.empty()) << testing::PrintToString(again.warnings);
    expect_same_scene(scene, again);
    GltfDocument::open(folder.path() / "again.glb").write(folder.path() / "third.gltf");
    expect_same_scene(scene, import_gltf(folder.path() / "third.gltf"));
}

// The material's own refraction is the default, which no file needs to have: a pointer wants it there.
TEST_F(PointerImport, WhatAPointerLeadsToIsWritten) {
    point("/materials/0/extensions/KHR_materials_ior/ior", {1, 2}, 1);
    const json document = json::parse(GltfDocument::of_scene(import(), "test").json_text());
    const json::json_pointer target(
        document["animations"][0]["channels"][0]["target"]["extensions"]["KHR_animation_pointer"]["pointer"]
            .get<std::string>());
    EXPECT_TRUE(document.contains(target.parent_pointer())) << document["materials"].dump();
    const json& used = document["extensionsUsed"];
    EXPECT_EQ(std::ranges::count(used, json("KHR_materials_ior")), 1);
    EXPECT_EQ(std::ranges::count(used, json("KHR_animation_pointer")), 1);
}

// --- emission is a product of two properties ---

TEST_F(PointerImport, AFactorIsTimesTheStrengthOfTheFile) {
    point("/materials/0/emissiveFactor", {1, 0, 0, 0, 0.5, 0}, 3);
    const SceneData scene = import();
    const PropertyChannel& channel = only(scene);
    EXPECT_EQ(channel.property, emissive);
    EXPECT_EQ(channel.keys.values, (std::vector<float>{8, 0, 0, 0, 4, 0}));
    EXPECT_EQ(channel.rest, (PropertyValue{4, 2, 0, 0}));
}

TEST_F(PointerImport, AStrengthIsTimesTheFactorOfTheFile) {
    point("/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength", {0, 100}, 1);
    const SceneData scene = import();
    const PropertyChannel& channel = only(scene);
    EXPECT_EQ(channel.property, emissive);
    EXPECT_EQ(channel.keys.width, 3u);
    EXPECT_EQ(channel.keys.values, (std::vector<float>{0, 0, 0, 50, 25, 0}));
}

TEST_F(PointerImport, BothAreKeptApart) {
    point("/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength", {2, 100}, 1);
    point("/materials/0/emissiveFactor", {1, 0, 0, 0, 0.5, 0}, 3);
    const SceneData scene = import();
    ASSERT_EQ(scene.animations.at(0).properties.size(), 2u);
    const PropertyChannel &factor = scene.animations[0].properties[0],
                          &strength = scene.animations[0].properties[1];
    EXPECT_EQ(factor.property, emissive);
    EXPECT_EQ(factor.keys.values, (std::vector<float>{1, 0, 0, 0, 0.5, 0}));
    EXPECT_EQ(factor.rest, (PropertyValue{4, 2, 0, 0})) << "nits";
    EXPECT_EQ(strength.property, emissive_scale);
    EXPECT_EQ(strength.keys.values, (std::vector<float>{2, 100}));
}

// --- what cannot be played ---

TEST_F(PointerImport, WhatIsNotThereIsLeftOutWithAWarning) {
    const std::string lights = "/extensions/KHR_lights_punctual/lights/";
    for (const auto& [at, part] :
         {std::pair(lights + "0/intensity", "there is no light 0 in the scene"),
          {lights + "9/intensity", "there is no light 9 in the scene"},
          {"/materials/4294967296/alphaCutoff", "is not animated here"},
          {"/materials/1/alphaCutoff", "there is no material 1 in the scene"},
          {"/cameras/2/perspective/yfov", "there is no camera 2 in the scene"},
          {"/materials/0/alphaCutoff/x", "is not animated here"},
          {"/materials/-1/alphaCutoff", "is not animated here"},
          {"/materials//alphaCutoff", "is not animated here"},
          {"/nodes/0/extensions/KHR_node_visibility/visible", "is not animated here"}}) {
        builder.json["animations"][0] = {{"samplers", json::array()}, {"channels", json::array()}};
        point(at, {0, 1}, 1);
        const SceneData scene = import();
        ASSERT_EQ(scene.warnings.size(), 2u) << at;
        EXPECT_TRUE(scene.warnings[0].starts_with("/animations/0/channels/0/target/path: "))
            << scene.warnings[0];
        EXPECT_NE(scene.warnings[0].find(part), std::string::npos) << scene.warnings[0];
        EXPECT_TRUE(scene.animations.empty());
    }
}

TEST_F(PointerImport, ValuesMustFit) {
    point("/materials/0/pbrMetallicRoughness/baseColorFactor", {0, 0, 0, 1, 1, 1}, 3);
    const SceneData scene = import();
    ASSERT_EQ(scene.warnings.size(), 2u);
    EXPECT_NE(scene.warnings[0].find("is no VEC4"), std::string::npos) << scene.warnings[0];
}

TEST_F(PointerImport, TheFirstOfTwoForTheSameCounts) {
    point("/materials/0/alphaCutoff", {0, 1}, 1);
    point("/materials/0/alphaCutoff", {1, 0}, 1);
    const SceneData scene = import();
    expect_warning(scene, "/animations/0/channels/1/target", "an earlier channel moves the same");
    EXPECT_EQ(scene.animations[0].properties.at(0).keys.values, (std::vector<float>{0, 1}));
}

}  // namespace
}  // namespace lanthorn
