// The table of extensions in docs/gltf.md against the importer: a file that uses an extension as people do is
// read in the way that its row says.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <sstream>
#include <string_view>

#include "engine/assets/gltf_extensions.h"
#include "tests/support/repository.h"
#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;

struct Case {
    std::function<void(GltfBuilder&)> use;
    std::function<bool(const SceneData&)> shows;  // what the extension says
};

// A material of the triangle whose extension NAME is `own`.
std::function<void(GltfBuilder&)> material_with(const char* name, const json& own) {
    return [=](GltfBuilder& builder) {
        builder.json["materials"] = {
            {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}, {"extensions", {{name, own}}}}};
        builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    };
}

const Material& material_of(const SceneData& scene) {
    return scene.materials.at(scene.meshes.at(0).material);
}

Case material_case(const char* name, const json& own, std::function<bool(const Material&)> shows) {
    return {material_with(name, own),
            [shows = std::move(shows)](const SceneData& scene) { return shows(material_of(scene)); }};
}

// What other loaders read and nobody here: the shapes are what they are without.
Case left_out(const char* name, const json& own) {
    return material_case(name, own, [](const Material& m) {
        Material plain;
        plain.metallic = 0;
        return m.base_colour == plain.base_colour && m.roughness == plain.roughness && m.ior == plain.ior &&
               m.specular == plain.specular && m.transmission == plain.transmission;
    });
}

void use_instances(GltfBuilder& builder) {
    builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
        builder.add_vec3({0, 0, 0, 5, 0, 0});
}

void use_pointer(GltfBuilder& builder) {
    builder.json["materials"] = {json::object()};
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    const json own = {{"pointer", "/materials/0/pbrMetallicRoughness/roughnessFactor"}};
    const json target = {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", own}}}};
    const json sampler = {{"input", builder.add_scalars(std::vector<float>{0, 1})},
                          {"output", builder.add_scalars(std::vector<float>{0, 1})}};
    builder.json["animations"] = json::array(
        {{{"samplers", json::array({sampler})}, {"channels", {{{"sampler", 0}, {"target", target}}}}}});
}

void use_lights(GltfBuilder& builder) {
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}}, {{"type", "point"}}, {{"type", "spot"}, {"spot", json::object()}}};
}

void use_variants(GltfBuilder& builder) {
    material_with("none", json::object())(builder);
    builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = {
        {{"material", 0}, {"variants", {0}}}};
    builder.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "Day"}}};
}

// As KHR_mesh_quantization allows it: positions in normalised bytes, padded to four.
void use_bytes(GltfBuilder& builder) {
    const int view =
        builder.add_view(GltfBuilder::bytes_of<std::uint8_t>({0, 0, 0, 0, 255, 0, 0, 0, 0, 51, 0, 0}), 4);
    const int positions = builder.add_accessor(view, 5121, "VEC3", 3);
    builder.json["accessors"][positions]["normalized"] = true;
    builder.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = positions;
}

void use_transforms(GltfBuilder& builder) {
    const json info = {{"index", builder.add_texture(make_png(1, 1, {255, 255, 255}, 3))},
                       {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}}}}}};
    builder.json["materials"] = {
        {{"pbrMetallicRoughness", {{"baseColorTexture", info}, {"metallicRoughnessTexture", info}}},
         {"normalTexture", info},
         {"occlusionTexture", info},
         {"emissiveTexture", info},
         {"extensions",
          {{"KHR_materials_specular", {{"specularTexture", info}, {"specularColorTexture", info}}},
           {"KHR_materials_transmission", {{"transmissionTexture", info}}}}}}};
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
}

bool shows_transforms(const SceneData& scene) {
    return std::ranges::all_of(material_of(scene).textures(), [](const TextureRef* ref) {
        return ref->present() && ref->uv_transform == std::array{vec3(1, 0, 0.5f), vec3(0, 1, 0.25f)};
    });
}

std::map<std::string, Case> cases() {
    const auto as_is = [](const SceneData& scene) { return scene.triangle_count() == 1; };
    std::map<std::string, Case> result = {
        {"EXT_mesh_gpu_instancing",
         {use_instances, [](const SceneData& scene) { return scene.nodes.size() == 3; }}},
        {"KHR_animation_pointer",
         {use_pointer, [](const SceneData& s) { return s.animations.at(0).properties.size() == 1; }}},
        {"KHR_lights_punctual",
         {use_lights,
          [](const SceneData& s) {
              return s.lights.at(0).type == LightType::directional &&
                     s.lights.at(1).type == LightType::point && s.lights.at(2).type == LightType::spot;
          }}},
        {"KHR_materials_variants", {use_variants, as_is}},
        {"KHR_mesh_quantization",
         {use_bytes,
          [](const SceneData& s) {
              return s.meshes.at(0).vertices[1].position == vec3(1, 0, 0) &&
                     s.meshes.at(0).vertices[2].position == vec3(0, 0.2f, 0);
          }}},
        {"KHR_node_visibility",
         {[](GltfBuilder& b) {
              b.json["nodes"][0]["extensions"]["KHR_node_visibility"] = {{"visible", false}};
          },
          [](const SceneData& scene) { return scene.triangle_count() == 0; }}},
        {"KHR_texture_transform", {use_transforms, shows_transforms}},
        {"KHR_xmp_json_ld", {[](GltfBuilder&) {}, as_is}},
    };
    const auto add = [&](const char* name, const json& own, std::function<bool(const Material&)> shows) {
        result[name] = material_case(name, own, std::move(shows));
    };
    result["KHR_materials_emissive_strength"] = {
        [](GltfBuilder& builder) {
            material_with("KHR_materials_emissive_strength", {{"emissiveStrength", 5}})(builder);
            builder.json["materials"][0]["emissiveFactor"] = {1, 0.5, 0};
        },
        [](const SceneData& scene) { return material_of(scene).emissive == vec3(5, 2.5f, 0); }};
    add("KHR_materials_ior", {{"ior", 1.2}}, [](const Material& m) { return m.ior == 1.2f; });
    add("KHR_materials_pbrSpecularGlossiness", {{"glossinessFactor", 0.25}},
        [](const Material& m) { return m.roughness == 0.75f; });
    add("KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0, 0}}},
        [](const Material& m) { return m.specular == 0.5f && m.specular_colour == vec3(1, 0, 0); });
    add("KHR_materials_transmission", {{"transmissionFactor", 0.5}},
        [](const Material& m) { return m.transmission == 0.5f; });
    add("KHR_materials_unlit", json::object(), [](const Material& m) { return m.unlit; });
    add("KHR_materials_volume", {{"thicknessFactor", 2}, {"attenuationDistance", 3}},
        [](const Material& m) { return m.thickness == 2 && m.attenuation_distance == 3; });
    add("KHR_materials_clearcoat", {{"clearcoatFactor", 1}},
        [](const Material& m) { return m.base_colour.x < 0.9f && m.base_colour.x > 0.8f; });
    add("KHR_materials_sheen", {{"sheenColorFactor", {0, 0, 1}}, {"sheenRoughnessFactor", 1}},
        [](const Material& m) { return m.base_colour.x < 1 && m.base_colour.z == 1; });
    for (const auto& [name, own] :
         {std::pair("KHR_materials_anisotropy", json{{"anisotropyStrength", 0.5}}),
          {"KHR_materials_diffuse_transmission", json{{"diffuseTransmissionFactor", 0.5}}},
          {"KHR_materials_dispersion", json{{"dispersion", 0.1}}},
          {"KHR_materials_iridescence", json{{"iridescenceFactor", 1}}}}) {
        result[name] = left_out(name, own);
    }
    return result;
}

// Those whose files take an encoder or images of many kinds, and what their tests show:
// compressed_import_test.cpp, extension_import_test.cpp, image_light_import_test.cpp.
const std::map<std::string, std::string> kTestedElsewhere = {{"EXT_lights_image_based", "read"},
                                                             {"EXT_meshopt_compression", "read"},
                                                             {"EXT_texture_webp", "read"},
                                                             {"KHR_draco_mesh_compression", "read"},
                                                             {"KHR_texture_basisu", "left out"}};

// The first table's rows: extension and how far it goes.
std::map<std::string, std::string> documented() {
    std::map<std::string, std::string> result;
    std::ifstream file(support::repository_file("docs/gltf.md"));
    for (std::string line; std::getline(file, line);) {
        std::istringstream cells(line);
        std::string skipped, names, level;
        std::getline(cells, skipped, '|');
        std::getline(cells, names, '|');
        std::getline(cells, level, '|');
        for (std::size_t at = names.find('`'); at != std::string::npos; at = names.find('`', at)) {
            const std::size_t end = names.find('`', at + 1);
            const std::string name = names.substr(at + 1, end - at - 1);
            if (name.starts_with("KHR_") || name.starts_with("EXT_")) {
                result[name] = level.substr(1, level.find_last_not_of(' '));
            }
            at = end + 1;
        }
    }
    return result;
}

class ExtensionTable : public ImportTest {};

TEST_F(ExtensionTable, EveryRowIsAsItSays) {
    std::map<std::string, std::string> rows = documented();
    for (const auto& [name, tried] : cases()) {
        SCOPED_TRACE(name);
        builder = GltfBuilder();
        builder.add_triangle();
        builder.json["extensionsUsed"] = {name};
        tried.use(builder);
        const SceneData scene = import();
        EXPECT_TRUE(tried.shows(scene));
        const std::string found = scene.warnings.empty() ? "read"
                                  : scene.warnings[0].find("is not read") != std::string::npos
                                      ? "left out"
                                      : "approximated";
        EXPECT_LE(scene.warnings.size(), 1u) << testing::PrintToString(scene.warnings);
        EXPECT_EQ(rows[name], found) << testing::PrintToString(scene.warnings);
        rows.erase(name);
    }
    EXPECT_EQ(rows, kTestedElsewhere) << "rows without a case";
}

TEST_F(ExtensionTable, WhatIsReadHasARowThatSaysSo) {
    std::set<std::string> read;
    for (const auto& [name, level] : documented()) {
        if (level != "left out") {
            read.insert(name);
        }
    }
    const std::span<const std::string_view> own = read_extensions();
    EXPECT_EQ(read, std::set<std::string>(own.begin(), own.end()));
}

// The paragraph on extensions that a file may require without being refused: `NAME`, or `START*` of many.
TEST_F(ExtensionTable, WhatMayBeRequiredIsListed) {
    std::ifstream file(support::repository_file("docs/gltf.md"));
    std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::size_t begin = text.find("A file may *require*");
    ASSERT_NE(begin, std::string::npos);
    text = text.substr(begin, text.find("\n\n", begin) - begin);
    std::set<std::string> listed;
    for (std::size_t at = text.find('`'); at != std::string::npos; at = text.find('`', at)) {
        const std::size_t end = text.find('`', at + 1);
        listed.insert(text.substr(at + 1, end - at - 1));
        at = end + 1;
    }
    std::set<std::string> known;
    for (const std::string_view name : extensions_left_out()) {
        known.emplace(name);
    }
    for (const std::string_view start : extension_starts_left_out()) {
        known.insert(std::string(start) + '*');
    }
    EXPECT_EQ(listed, known);
}

}  // namespace
}  // namespace lanthorn
