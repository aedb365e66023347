// GltfDocument's setters: they change what they are asked to and nothing else, and refuse what glTF does not
// allow.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "lanthorn/assets/gltf_document.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "tests/unit/assets/gltf_builder.h"

namespace lanthorn {
namespace {

using nlohmann::json;

// As a person writes it: numbers in many spellings, members that nobody knows, a matrix.
constexpr const char* kText = R"({
  "asset": {"version": "2.0", "copyright": "\u00a9 me"},
  "extensionsUsed": ["X_unknown", "KHR_lights_punctual"],
  "extensions": {"KHR_lights_punctual": {"lights": [
    {"type": "spot", "intensity": 1e1, "color": [1.0, 0.50, 0], "spot": {"outerConeAngle": 0.5000}, "name": "l"}
  ]}},
  "scene": 0,
  "scenes": [{"nodes": [0, 1], "extras": 7}],
  "nodes": [
    {"name": "h\u00fctte", "translation": [1.0000, 2, 3e0], "rotation": [0, 0, 0.70710678, 0.70710678],
     "extras": {"door": {"open": 1.90}, "other": [1,2]}, "X_own": true},
    {"matrix": [2,0,0,0, 0,2.0,0,0, 0,0,2,0, 5,6,7,1], "children": [2], "camera": 0},
    {"extensions": {"KHR_lights_punctual": {"light": 0}, "X_unknown": {"a": 1}}, "extras": [1]}
  ],
  "cameras": [{"type": "perspective", "perspective": {"yfov": 0.80, "znear": 0.10, "aspectRatio": 1.5}}],
  "materials": [
    {"name": "m", "pbrMetallicRoughness": {"roughnessFactor": 0.250}, "emissiveFactor": [1,1,0],
     "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 10.0}}, "X_own": {}},
    {}
  ]
}
)";

class DocumentPatch : public testing::Test {
  protected:
    DocumentPatch() : path_(folder_.write("a.gltf", kText)), document_(GltfDocument::open(path_)) {}

    // The text with every `from` replaced by `to`.
    static std::string edited(std::initializer_list<std::pair<const char*, const char*>> edits) {
        std::string text = kText;
        for (const auto& [from, to] : edits) {
            const std::size_t at = text.find(from);
            EXPECT_NE(at, std::string::npos) << from;
            text.replace(at, std::string(from).size(), to);
        }
        return text;
    }
    SceneData imported() const {
        document_.write(folder_.path() / "b.gltf");
        return import_gltf(folder_.path() / "b.gltf");
    }
    void expect_refused(const std::function<void()>& call, const std::string& place,
                        const std::string& part) {
        const std::string before = document_.json_text();
        try {
            call();
            ADD_FAILURE() << "accepted, expected a refusal at " << place;
        } catch (const InputError& error) {
            const std::string line = error.what();
            EXPECT_TRUE(line.starts_with(path_.string() + ": " + place + ": ")) << line;
            EXPECT_NE(line.find(part), std::string::npos) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        }
        EXPECT_EQ(document_.json_text(), before);
    }

    TemporaryFolder folder_;
    std::filesystem::path path_;
    GltfDocument document_;
};

TEST_F(DocumentPatch, SettingWhatIsThereChangesNothing) {
    const SceneData scene = import_gltf(path_);
    ASSERT_EQ(scene.nodes.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        document_.set_node_name(i, document_.node_name(i));
        document_.set_transform(i, scene.nodes[i].local, scene.nodes[i].shear);
        document_.set_node_camera(i, scene.nodes[i].camera);
        document_.set_node_light(i, scene.nodes[i].light);
        document_.set_extras(i, scene.nodes[i].extras);
    }
    document_.set_extra(0, "door", R"({"open":1.9})");
    document_.set_light(0, scene.lights.at(0));
    document_.set_camera(0, scene.cameras.at(0));
    document_.set_material(0, scene.materials.at(0));
    document_.set_material(1, scene.materials.at(1));
    EXPECT_EQ(document_.node_name(0), "h\xc3\xbctte");
    EXPECT_EQ(document_.json_text(), kText);
}

TEST_F(DocumentPatch, NodesMove) {
    Transform local = import_gltf(path_).nodes[0].local;
    local.translation.y = 2.5;
    document_.set_transform(0, local);
    EXPECT_EQ(document_.json_text(), edited({{"[1.0000, 2, 3e0]", "[1.0,2.5,3.0]"}}));
    local.scale = vec3(1, 2, 1);
    local.rotation = quat(1, 0, 0, 0);
    document_.set_transform(0, local);
    EXPECT_EQ(imported().nodes[0].local, local);
}

TEST_F(DocumentPatch, AMatrixBecomesTranslationRotationAndScaleOnceItIsEdited) {
    Transform local = import_gltf(path_).nodes[1].local;
    local.translation.x = 0.1;
    document_.set_transform(1, local);
    EXPECT_EQ(document_.json_text(),
              edited({{R"("matrix": [2,0,0,0, 0,2.0,0,0, 0,0,2,0, 5,6,7,1], )", ""},
                      {R"("camera": 0})",
                       R"("camera": 0, "translation": [0.1,6.0,7.0], "scale": [2.0,2.0,2.0]})"}}));
    EXPECT_EQ(imported().nodes[1].local, local);
    mat3 shear(1);
    shear[1][0] = 0.5f;
    document_.set_transform(1, local, shear);
    const NodeData sheared = imported().nodes[1];
    EXPECT_NE(document_.json_text().find("\"matrix\""), std::string::npos);
    EXPECT_EQ(sheared.local.translation, local.translation);
    EXPECT_NEAR(sheared.shear[1][0], 0.5f, 1e-6f);
}

TEST_F(DocumentPatch, ExtrasMemberByMember) {
    document_.set_extra(0, "door", R"({"open": 0})");
    document_.set_extra(0, "lantern", "true");
    document_.remove_extra(0, "other");
    EXPECT_EQ(document_.json_text(),
              edited({{R"({"open": 1.90}, "other": [1,2])", R"({"open":0}, "lantern": true)"}}));
    document_.set_extra(1, "a", "1");
    EXPECT_EQ(document_.extras(1), R"({"a":1})");
    document_.remove_extra(1, "a");
    EXPECT_EQ(document_.extras(1), "");
    document_.remove_extra(1, "a");
    expect_refused([&] { document_.set_extra(0, "door", "{open"); }, "/nodes/0/extras/door", "expected JSON");
    expect_refused([&] { document_.set_extra(2, "door", "1"); }, "/nodes/2/extras", "found no object");
}

TEST_F(DocumentPatch, LightsCamerasAndMaterials) {
    const SceneData scene = import_gltf(path_);
    Light light = scene.lights[0];
    light.intensity = 12.5f;
    document_.set_light(0, light);
    Camera camera = scene.cameras[0];
    camera.z_far = 100;
    document_.set_camera(0, camera);
    Material material = scene.materials[0];
    material.base_colour = {0.1f, 0.2f, 0.3f, 1};
    material.emissive = {3, 0.1f, 0};
    document_.set_material(0, material);
    Material glass;
    glass.transmission = 1;
    glass.double_sided = true;
    glass.thickness = 0.5f;
    glass.attenuation_distance = 2;
    document_.set_material(1, glass);
    EXPECT_EQ(
        document_.json_text(),
        edited(
            {{R"("intensity": 1e1)", R"("intensity": 12.5)"},
             {R"("aspectRatio": 1.5)", R"("aspectRatio": 1.5, "zfar": 100.0)"},
             {R"("roughnessFactor": 0.250)",
              R"("roughnessFactor": 0.250, "baseColorFactor": [0.1,0.2,0.3,1.0])"},
             {R"("emissiveFactor": [1,1,0])", R"("emissiveFactor": [0.75,0.025,0.0])"},
             {R"("emissiveStrength": 10.0)", R"("emissiveStrength": 4.0)"},
             {"    {}\n",
              R"(    {"doubleSided":true,"extensions":{"KHR_materials_transmission":{"transmissionFactor":1.0},"KHR_materials_volume":{"thicknessFactor":0.5,"attenuationDistance":2.0}}})"
              "\n"},
             {R"("KHR_lights_punctual"],)",
              R"("KHR_lights_punctual", "KHR_materials_transmission", "KHR_materials_volume"],)"}}));
    const SceneData changed = imported();
    EXPECT_EQ(changed.lights[0], light);
    EXPECT_EQ(changed.cameras[0], camera);
    EXPECT_EQ(changed.materials[0].base_colour, material.base_colour);
    EXPECT_EQ(changed.materials[0].emissive, material.emissive);
    EXPECT_EQ(changed.materials[1].transmission, 1);
    EXPECT_EQ(changed.materials[1].thickness, 0.5f);
    EXPECT_EQ(changed.materials[1].attenuation_distance, 2);
    EXPECT_TRUE(changed.materials[1].double_sided);
}

TEST_F(DocumentPatch, EmissionComesBackExactly) {
    Material material = import_gltf(path_).materials[0];
    for (const vec3& emissive :
         {vec3(17, 12, 4), vec3(0.3f, 0.1f, 0.7f), vec3(1e-7f, 1e6f, 33.3f), vec3(0)}) {
        material.emissive = emissive;
        document_.set_material(0, material);
        EXPECT_EQ(imported().materials[0].emissive, emissive);
    }
}

// The importer puts these layers into the material's factors; written beside them they would count twice.
TEST_F(DocumentPatch, LayersThatTheImporterRestatesCountOnce) {
    const auto path = folder_.write("coat.gltf", R"({"asset":{"version":"2.0"},"materials":[{"extensions":{
            "KHR_materials_clearcoat":{"clearcoatFactor":1},
            "KHR_materials_sheen":{"sheenColorFactor":[1,0,0],"sheenRoughnessFactor":0.5}}}]})");
    const Material material = import_gltf(path).materials.at(0);
    GltfDocument document = GltfDocument::open(path);
    document.set_material(0, material);
    document.write(folder_.path() / "coat2.gltf");
    const Material again = import_gltf(folder_.path() / "coat2.gltf").materials.at(0);
    EXPECT_EQ(again.base_colour, material.base_colour);
    EXPECT_EQ(again.specular_colour, material.specular_colour);
}

// Glossiness that is a texture stays one, as roughness, and is made once for two materials.
TEST_F(DocumentPatch, TexturesOfGlossinessStay) {
    GltfBuilder builder;
    const int diffuse = builder.add_texture(make_png(1, 1, {10, 20, 30}, 3));
    const int glossiness = builder.add_texture(make_png(1, 1, {200, 100, 50, 204}, 4));
    const nlohmann::json material = {
        {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", glossiness}}}}},
        {"extensions",
         {{"KHR_materials_pbrSpecularGlossiness",
           {{"diffuseTexture", {{"index", diffuse}}},
            {"specularFactor", {0.5, 0.5, 0.5}},
            {"glossinessFactor", 0.5},
            {"specularGlossinessTexture", {{"index", glossiness}, {"texCoord", 1}}}}}}}};
    builder.add_material(material);
    builder.add_triangle()["material"] = builder.add_material(material);
    const auto path = folder_.write("gloss.gltf", builder.gltf());
    const SceneData scene = import_gltf(path);
    GltfDocument document = GltfDocument::open(path);
    document.set_material(0, scene.materials.at(0));
    document.set_material(1, scene.materials.at(1));
    document.write(folder_.path() / "restated.glb");
    const SceneData again = import_gltf(folder_.path() / "restated.glb");
    EXPECT_EQ(again.warnings, scene.warnings);
    EXPECT_EQ(again.images.size(), 3u);
    const auto texel = [](const SceneData& of, const TextureRef& ref) {
        return of.images[of.textures.at(ref.texture).image].rgba;
    };
    for (const auto member : {&Material::base_colour_texture, &Material::specular_colour_texture,
                              &Material::metallic_roughness_texture}) {
        const TextureRef &was = scene.materials[1].*member, &is = again.materials.at(1).*member;
        ASSERT_TRUE(was.present() && is.present());
        EXPECT_EQ(texel(again, is), texel(scene, was));
        EXPECT_EQ(is.uv_set, was.uv_set);
    }
    EXPECT_EQ(again.materials[1].specular_colour, scene.materials[1].specular_colour);
    EXPECT_EQ(again.materials[1].roughness, 1);
    EXPECT_EQ(texel(again, again.materials[1].metallic_roughness_texture)[1], 153);
}

TEST_F(DocumentPatch, LightsAndCamerasChangeTheirKind) {
    Light light;
    light.type = LightType::point;
    light.range = 4;
    document_.set_light(0, light);
    Camera camera;
    camera.orthographic = true;
    camera.z_far = 10;
    document_.set_camera(0, camera);
    EXPECT_EQ(imported().lights[0], light);
    EXPECT_EQ(imported().cameras[0], camera);
    light.range = std::numeric_limits<float>::infinity();
    document_.set_light(0, light);
    EXPECT_EQ(imported().lights[0], light);
}

TEST_F(DocumentPatch, NodesComeAndGo) {
    const std::size_t root = document_.add_node("new \"root\"");
    const std::size_t child = document_.add_node("child", static_cast<std::uint32_t>(root));
    EXPECT_EQ(root, 3u);
    document_.set_node_camera(child, 0);
    document_.set_node_light(child, 0);
    SceneData scene = imported();
    ASSERT_EQ(scene.nodes.size(), 5u);
    EXPECT_EQ(scene.nodes[3].name, "new \"root\"");
    EXPECT_EQ(scene.nodes[4].parent, 3u);
    EXPECT_EQ(scene.nodes[4].light, 0u);

    document_.set_parent(1, 0);
    scene = imported();
    EXPECT_EQ(scene.nodes[1].camera, 0u);
    EXPECT_EQ(scene.nodes[1].parent, 0u);
    document_.remove_node(1);
    EXPECT_EQ(imported().nodes.size(), 3u) << "node 2 went with it";
    EXPECT_EQ(document_.node_count(), 5u) << "no other node got another number";
    document_.set_parent(1, kNone);
    EXPECT_EQ(imported().nodes.size(), 5u);
    document_.set_node_light(child, kNone);
    document_.set_node_camera(child, kNone);
    EXPECT_EQ(imported().nodes[2].light, kNone);
}

TEST_F(DocumentPatch, RemovingAnAddedNodeRestoresTheScene) {
    document_.remove_node(document_.add_node("x"));
    const std::string text = document_.json_text();
    EXPECT_NE(text.find(R"("scenes": [{"nodes": [0, 1], "extras": 7}])"), std::string::npos) << text;
}

TEST_F(DocumentPatch, WithoutScenesRemovingMakesOne) {
    const GltfDocument& source = document_;
    GltfDocument bare = GltfDocument::open(folder_.write(
        "bare.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"children":[1]},{},{"name":"c"}]})"));
    bare.remove_node(1);
    bare.write(folder_.path() / "c.gltf");
    EXPECT_EQ(import_gltf(folder_.path() / "c.gltf").nodes.size(), 2u);
    EXPECT_EQ(source.node_count(), 3u);
}

TEST_F(DocumentPatch, WhatGltfDoesNotAllowIsRefused) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Transform local;
    expect_refused([&] { document_.set_transform(9, local); }, "/nodes/9", "expected one below 3");
    EXPECT_THROW(document_.set_node_name(0, "\xff"), InputError);
    local.translation.x = 1e300;
    expect_refused([&] { document_.set_transform(0, local); }, "/nodes/0/translation", "finite");
    local = {};
    local.scale.y = nan;
    expect_refused([&] { document_.set_transform(0, local); }, "/nodes/0/scale", "finite");
    local = {};
    local.rotation = quat(0, 0, 0, 0);
    expect_refused([&] { document_.set_transform(0, local); }, "/nodes/0/rotation", "unit length");
    expect_refused([&] { document_.set_node_camera(0, 1); }, "/nodes/0/camera", "expected an index below 1");
    expect_refused([&] { document_.set_node_light(0, 1); }, "/nodes/0/extensions/KHR_lights_punctual/light",
                   "below 1");
    expect_refused([&] { document_.set_node_mesh(0, 0); }, "/nodes/0/mesh", "below 0");
    expect_refused([&] { document_.set_parent(1, 2); }, "/nodes/2/children", "node 1 stands above node 2");
    expect_refused([&] { document_.set_parent(1, 1); }, "/nodes/1/children", "expected a tree");
    expect_refused([&] { document_.add_node("x", 3); }, "/nodes/3", "expected one below 3");
    Material material;
    material.metallic = 1.5f;
    expect_refused([&] { document_.set_material(0, material); },
                   "/materials/0/pbrMetallicRoughness/metallicFactor", "found 1.5, expected 0..1");
    material = {};
    material.emissive.x = nan;
    expect_refused([&] { document_.set_material(0, material); }, "/materials/0/emissiveFactor/0",
                   "found nan");
    material = {};
    material.normal_texture.texture = 0;
    expect_refused([&] { document_.add_material(material); }, "/materials/2/normalTexture/index", "below 0");
    Light light;
    light.intensity = -1;
    expect_refused([&] { document_.set_light(0, light); },
                   "/extensions/KHR_lights_punctual/lights/0/intensity", "found -1");
    expect_refused([&] { document_.set_light(1, Light{}); }, "/extensions/KHR_lights_punctual/lights/1",
                   "below 1");
    Camera camera;
    camera.z_far = 0.01f;
    expect_refused([&] { document_.set_camera(0, camera); }, "/cameras/0/perspective/zfar", "found 0.01");
    expect_refused([&] { document_.add_mesh({}); }, "/meshes/0/primitives", "at least one");
    expect_refused([&] { document_.add_skin({}); }, "/skins/0/inverseBindMatrices", "found 0 joints");
    expect_refused([&] { document_.add_animation({}); }, "/animations/0/channels", "at least one");
}

TEST_F(DocumentPatch, ACopyIsAnUndo) {
    const GltfDocument before = document_;
    document_.remove_node(0);
    document_.add_image({"i", 1, 1, {1, 2, 3, 4}});
    EXPECT_EQ(before.json_text(), kText);
    document_ = before;
    EXPECT_EQ(document_.json_text(), kText);
}

TEST_F(DocumentPatch, HidesAndShowsNodes) {
    document_.set_node_visible(1, true);
    EXPECT_EQ(document_.json_text(), kText);  // nothing said so before, either
    document_.set_node_visible(1, false);
    const SceneData hidden = imported();
    EXPECT_EQ(hidden.nodes.size(), 3u);
    EXPECT_EQ(hidden.nodes[2].light, kNone);  // of its child
    EXPECT_NE(document_.json_text().find(R"("KHR_lights_punctual", "KHR_node_visibility")"),
              std::string::npos);
    document_.set_node_visible(1, true);
    EXPECT_EQ(imported().nodes[2].light, 0u);
    EXPECT_THROW(document_.set_node_visible(9, true), InputError);
}

}  // namespace
}  // namespace lanthorn
