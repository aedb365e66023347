// Materials, textures and their images.
#include <fmt/format.h>

#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;

class MaterialImport : public ImportTest {
  protected:
    SceneData import_material(const json& material) {
        builder.add_material(material);
        return import();
    }
    std::string white() const { return make_png(1, 1, {255, 255, 255}, 3); }
};

TEST_F(MaterialImport, Defaults) {
    const Material material = import_material(json::object()).materials.at(0);
    EXPECT_EQ(material.base_colour, vec4(1));
    EXPECT_EQ(material.metallic, 1);
    EXPECT_EQ(material.roughness, 1);
    EXPECT_EQ(material.emissive, vec3(0));
    EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(material.alpha_cutoff, 0.5f);
    EXPECT_EQ(material.ior, 1.5f);
    EXPECT_EQ(material.specular, 1);
    EXPECT_EQ(material.transmission, 0);
    EXPECT_FALSE(material.bounds_volume());
    EXPECT_EQ(material.absorption(), vec3(0));
    EXPECT_FALSE(material.double_sided || material.unlit || material.emits());
    EXPECT_FALSE(material.base_colour_texture.present());
}

TEST_F(MaterialImport, EveryFactor) {
    const SceneData scene = import_material(
        {{"name", "glass"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}, {"metallicFactor", 0.25}, {"roughnessFactor", 0.75}}},
         {"emissiveFactor", {1, 0.5, 0}},
         {"alphaMode", "MASK"},
         {"alphaCutoff", 0.3},
         {"doubleSided", true},
         {"extensions",
          {{"KHR_materials_emissive_strength", {{"emissiveStrength", 5000000000}}},
           {"KHR_materials_ior", {{"ior", 1.33}}},
           {"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {0.2, 2, 0.4}}}},
           {"KHR_materials_transmission", {{"transmissionFactor", 0.9}}},
           {"KHR_materials_volume",
            {{"thicknessFactor", 0.4}, {"attenuationDistance", 2.5}, {"attenuationColor", {0.5, 1, 0}}}},
           {"KHR_materials_unlit", json::object()}}}});
    const Material& material = scene.materials.at(0);
    EXPECT_EQ(material.name, "glass");
    EXPECT_EQ(material.base_colour, vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(material.metallic, 0.25f);
    EXPECT_EQ(material.roughness, 0.75f);
    EXPECT_EQ(material.emissive, vec3(5e9f, 2.5e9f, 0));
    EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
    EXPECT_EQ(material.alpha_cutoff, 0.3f);
    EXPECT_TRUE(material.double_sided);
    EXPECT_TRUE(material.unlit);
    EXPECT_EQ(material.ior, 1.33f);
    EXPECT_EQ(material.specular, 0.5f);
    EXPECT_EQ(material.specular_colour, vec3(0.2f, 2, 0.4f));
    EXPECT_EQ(material.transmission, 0.9f);
    EXPECT_EQ(material.thickness, 0.4f);
    EXPECT_TRUE(material.bounds_volume());
    EXPECT_EQ(material.attenuation_distance, 2.5f);
    EXPECT_EQ(material.attenuation_colour, vec3(0.5f, 1, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

// After the attenuation distance the attenuation colour is left, after twice that its square.
TEST_F(MaterialImport, VolumesAbsorb) {
    Material m;
    m.attenuation_distance = 2;
    m.attenuation_colour = vec3(0.5f, 1, 0);
    const vec3 a = m.absorption();
    EXPECT_NEAR(std::exp(-2 * a.x), 0.5f, 1e-6);
    EXPECT_NEAR(std::exp(-4 * a.x), 0.25f, 1e-6);
    EXPECT_EQ(a.y, 0);
    EXPECT_TRUE(std::isfinite(a.z));
    EXPECT_LT(std::exp(-2 * a.z), 1e-6);
}

// What exporters call see-through, for want of a look at its texture.
TEST_F(MaterialImport, BlendsWithoutAnythingToSeeThroughAreOpaque) {
    const int closed = builder.add_texture(make_png(2, 1, {255, 0, 0, 255, 0, 255, 0, 255}, 4));
    const int open = builder.add_texture(make_png(2, 1, {255, 0, 0, 255, 0, 255, 0, 254}, 4));
    const auto textured = [](int texture) {
        return json{{"alphaMode", "BLEND"},
                    {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}};
    };
    const json plain = {{"alphaMode", "BLEND"}};
    builder.add_material(plain);
    builder.add_material(textured(closed));
    builder.add_material(textured(open));
    builder.add_material(
        {{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.99}}}}});
    for (const float alpha : {1.0f, 0.5f}) {
        const std::vector<float> colours = {1, 1, 1, 1, 1, 1, 1, alpha, 1, 1, 1, 1};
        builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})},
                               {"COLOR_0", builder.add(colours, "VEC4", 4)}})["material"] =
            builder.add_material(plain);
    }
    const int animated = builder.add_material(plain);
    builder.json["extensionsUsed"] = {"KHR_animation_pointer"};
    const std::string pointer = fmt::format("/materials/{}/pbrMetallicRoughness/baseColorFactor", animated);
    const json target = {{"path", "pointer"},
                         {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
    const int times = builder.add_scalars(std::vector<float>{0, 1});
    const int colours = builder.add(std::vector<float>{1, 1, 1, 1, 1, 1, 1, 0}, "VEC4", 4);
    const json sampler = {{"input", times}, {"output", colours}};
    const json channel = {{"sampler", 0}, {"target", target}};
    builder.json["animations"] =
        json::array({{{"samplers", json::array({sampler})}, {"channels", json::array({channel})}}});
    const SceneData scene = import();
    std::vector<AlphaMode> modes;
    for (const Material& material : scene.materials) {
        modes.push_back(material.alpha_mode);
    }
    constexpr AlphaMode opaque = AlphaMode::opaque, blend = AlphaMode::blend;
    EXPECT_EQ(modes, (std::vector{opaque, opaque, blend, blend, opaque, blend, blend}));
    expect_warning(scene, "/materials/0/alphaMode",
                   "its alpha is 1 everywhere; OPAQUE is used (and at 2 more places)");
}

// Foliage whose texture is lost is no wall.
TEST_F(MaterialImport, BlendsWhoseTextureIsLostStayBlends) {
    const std::string png = make_png(1, 1, {9, 9, 9, 0}, 4);
    const int whole = builder.add_texture(png);
    const int broken = builder.add_texture(png.substr(0, 20));
    json& textures = builder.json["textures"];
    builder.json["images"].push_back({{"uri", "none.png"}});
    textures.push_back({{"source", builder.json["images"].size() - 1}});
    const std::size_t missing = textures.size() - 1;
    textures.push_back({{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}});
    const std::size_t packed = textures.size() - 1;
    for (const std::size_t texture : {static_cast<std::size_t>(broken), missing, packed}) {
        const json info = {{"index", texture}};
        builder.add_material(
            {{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorTexture", info}}}});
        builder.add_material(
            {{"alphaMode", "BLEND"},
             {"extensions", {{"KHR_materials_pbrSpecularGlossiness", {{"diffuseTexture", info}}}}}});
    }
    const auto info = [&](int set) { return json{{"index", whole}, {"texCoord", set}}; };
    builder.add_material({{"alphaMode", "BLEND"},
                          {"pbrMetallicRoughness", {{"baseColorTexture", info(2)}}},
                          {"normalTexture", info(0)},
                          {"emissiveTexture", info(1)}});
    const SceneData scene = import();
    ASSERT_EQ(scene.materials.size(), 7u);
    for (const Material& material : scene.materials) {
        EXPECT_FALSE(material.base_colour_texture.present());
        EXPECT_EQ(material.alpha_mode, AlphaMode::blend);
    }
}

TEST_F(MaterialImport, IorOfZeroIsInfinite) {
    EXPECT_EQ(import_material({{"extensions", {{"KHR_materials_ior", {{"ior", 0}}}}}}).materials.at(0).ior,
              1e3f);
}

TEST_F(MaterialImport, FactorsOutOfRangeAreClampedWithAWarning) {
    const SceneData scene = import_material({{"pbrMetallicRoughness", {{"metallicFactor", 1.5}}}});
    EXPECT_EQ(scene.materials.at(0).metallic, 1);
    expect_warning(scene, "/materials/0/pbrMetallicRoughness/metallicFactor",
                   "1.5 is outside 0..1; 1 is used");
}

TEST_F(MaterialImport, WrongTypesAreRefusedWithTheirPlace) {
    builder.add_material({{"pbrMetallicRoughness", {{"metallicFactor", "shiny"}}}});
    expect_refused("/materials/0/pbrMetallicRoughness/metallicFactor", "found \"shiny\"");
    builder.json["materials"][0] = {{"emissiveFactor", {1, 2}}};
    expect_refused("/materials/0/emissiveFactor", "found 2 elements, expected an array of 3 numbers");
    builder.json["materials"][0] = {{"emissiveFactor", {1, 2, nullptr}}};
    expect_refused("/materials/0/emissiveFactor/2", "found null");
    builder.json["materials"][0] = {{"doubleSided", 1}};
    expect_refused("/materials/0/doubleSided", "expected true or false");
    builder.json["materials"][0] = {{"extensions", {{"KHR_materials_ior", 3}}}};
    expect_refused("/materials/0/extensions/KHR_materials_ior", "expected an object");
    builder.json["materials"][0] = {{"normalTexture", {{"index", 0}}}};
    expect_refused("/materials/0/normalTexture/index", "there are no textures");
}

TEST_F(MaterialImport, EveryTextureSlotAndItsSampler) {
    const int texture = builder.add_texture(white());
    builder.json["samplers"] = {
        {{"magFilter", 9728}, {"minFilter", 9984}, {"wrapS", 33071}, {"wrapT", 33648}}};
    builder.json["textures"][texture]["sampler"] = 0;
    const json info = {{"index", texture}, {"texCoord", 1}};
    const SceneData scene = import_material(
        {{"pbrMetallicRoughness", {{"baseColorTexture", info}, {"metallicRoughnessTexture", info}}},
         {"normalTexture", {{"index", texture}, {"scale", 0.5}}},
         {"occlusionTexture", {{"index", texture}, {"strength", 0.25}}},
         {"emissiveTexture", info},
         {"extensions",
          {{"KHR_materials_specular", {{"specularTexture", info}, {"specularColorTexture", info}}},
           {"KHR_materials_transmission", {{"transmissionTexture", info}}}}}});
    const Material& m = scene.materials.at(0);
    for (const TextureRef& ref : {m.base_colour_texture, m.metallic_roughness_texture, m.emissive_texture,
                                  m.specular_texture, m.specular_colour_texture, m.transmission_texture}) {
        EXPECT_TRUE(ref.present());
        EXPECT_EQ(ref.uv_set, 1u);
    }
    EXPECT_TRUE(m.normal_texture.present() && m.occlusion_texture.present());
    EXPECT_EQ(m.normal_scale, 0.5f);
    EXPECT_EQ(m.occlusion_strength, 0.25f);
    ASSERT_EQ(scene.textures.size(), 1u);
    const Sampler sampler = scene.textures[0].sampler;
    EXPECT_EQ(sampler.mag, Filter::nearest);
    EXPECT_EQ(sampler.min, Filter::nearest);
    EXPECT_TRUE(sampler.mipmaps);
    EXPECT_EQ(sampler.wrap_s, Wrap::clamp_to_edge);
    EXPECT_EQ(sampler.wrap_t, Wrap::mirrored_repeat);
}

// KHR_texture_transform: scaled, then turned counter-clockwise (V points down), then moved.
TEST_F(MaterialImport, TextureTransform) {
    const int texture = builder.add_texture(white());
    const json transform = {
        {"offset", {0.5, 0.25}}, {"rotation", kPi / 2}, {"scale", {2, 3}}, {"texCoord", 1}};
    const Material material =
        import_material({{"pbrMetallicRoughness",
                          {{"baseColorTexture",
                            {{"index", texture}, {"extensions", {{"KHR_texture_transform", transform}}}}}}}})
            .materials.at(0);
    const TextureRef& ref = material.base_colour_texture;
    EXPECT_EQ(ref.uv_set, 1u);
    const vec3 uv(1, 1, 1);
    EXPECT_NEAR(glm::dot(ref.uv_transform[0], uv), 3 + 0.5, 1e-6);
    EXPECT_NEAR(glm::dot(ref.uv_transform[1], uv), -2 + 0.25, 1e-6);
}

TEST_F(MaterialImport, ATextureInAnExtensionHasItsTransformToo) {
    const int texture = builder.add_texture(white());
    const json info = {{"index", texture},
                       {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}}}}}};
    const Material material =
        import_material({{"extensions", {{"KHR_materials_transmission", {{"transmissionTexture", info}}}}}})
            .materials.at(0);
    EXPECT_EQ(material.transmission_texture.uv_transform[0], vec3(1, 0, 0.5f));
    EXPECT_EQ(material.transmission_texture.uv_transform[1], vec3(0, 1, 0.25f));
}

TEST_F(MaterialImport, TexelsAreRgbaFromTheTop) {
    const int texture = builder.add_texture(make_png(1, 2, {255, 0, 0, 10, 0, 0, 255, 200}, 4));
    const SceneData scene =
        import_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
    const Image& image = scene.images.at(0);
    EXPECT_EQ(image.width, 1u);
    EXPECT_EQ(image.height, 2u);
    EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{255, 0, 0, 10, 0, 0, 255, 200}))
        << "alpha must not multiply";
}

TEST_F(MaterialImport, GreyAndSixteenBitImages) {
    const int grey = builder.add_texture(make_png(2, 1, {0, 77}, 1));
    const int grey_alpha = builder.add_texture(make_png(1, 1, {90, 40}, 2));
    const int deep = builder.add_texture(make_png16(1, 1, {65535, 257 * 100, 0}, 3));
    const SceneData scene = import_material({{"normalTexture", {{"index", grey}}},
                                             {"occlusionTexture", {{"index", grey_alpha}}},
                                             {"emissiveTexture", {{"index", deep}}}});
    const Material& m = scene.materials.at(0);
    const auto texels = [&](const TextureRef& ref) {
        return scene.images[scene.textures[ref.texture].image].rgba;
    };
    EXPECT_EQ(texels(m.normal_texture), (std::vector<std::uint8_t>{0, 0, 0, 255, 77, 77, 77, 255}));
    EXPECT_EQ(texels(m.occlusion_texture), (std::vector<std::uint8_t>{90, 90, 90, 40}));
    EXPECT_EQ(texels(m.emissive_texture), (std::vector<std::uint8_t>{255, 100, 0, 255}));
}

TEST_F(MaterialImport, ExternalImageWithEscapedName) {
    folder.write("a b.png", white());
    builder.json["images"] = {{{"uri", "a%20b.png"}}};
    builder.json["textures"] = {{{"source", 0}}};
    const SceneData scene = import_material({{"emissiveTexture", {{"index", 0}}}});
    EXPECT_EQ(scene.images.size(), 1u);
    EXPECT_TRUE(scene.warnings.empty()) << testing::PrintToString(scene.warnings);
}

TEST_F(MaterialImport, ImageInADataUri) {
    builder.json["images"] = {{{"uri", "data:image/png;base64," + base64(white())}}};
    builder.json["textures"] = {{{"source", 0}}};
    EXPECT_EQ(import_material({{"emissiveTexture", {{"index", 0}}}}).images.size(), 1u);
}

// A broken image is damage that stays where it is: the material goes without that texture.
TEST_F(MaterialImport, BrokenImagesAreLeftOut) {
    const std::string png = make_png(64, 64, std::vector<std::uint8_t>(64 * 64 * 3, 9), 3);
    const int whole = builder.add_texture(png);
    const int cut = builder.add_texture(png.substr(0, 50));
    const int garbage = builder.add_texture("no image at all");
    builder.json["images"].push_back({{"uri", "missing.png"}});
    builder.json["textures"].push_back({{"source", 3}});
    builder.json["images"].push_back({{"uri", "data:image/png;base64,@@@"}});
    builder.json["textures"].push_back({{"source", 4}});
    builder.json["textures"].push_back(json::object());
    const SceneData scene = import_material(
        {{"pbrMetallicRoughness",
          {{"baseColorTexture", {{"index", cut}}}, {"metallicRoughnessTexture", {{"index", garbage}}}}},
         {"normalTexture", {{"index", 3}}},
         {"occlusionTexture", {{"index", 4}}},
         {"emissiveTexture", {{"index", whole}}},
         {"extensions", {{"KHR_materials_transmission", {{"transmissionTexture", {{"index", 5}}}}}}}});
    const Material& m = scene.materials.at(0);
    EXPECT_FALSE(m.base_colour_texture.present());
    EXPECT_FALSE(m.metallic_roughness_texture.present());
    EXPECT_FALSE(m.normal_texture.present());
    EXPECT_FALSE(m.occlusion_texture.present());
    EXPECT_FALSE(m.transmission_texture.present());
    ASSERT_TRUE(m.emissive_texture.present());
    EXPECT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.warnings.size(), 5u) << testing::PrintToString(scene.warnings);
}

TEST_F(MaterialImport, UnusedImagesAreNotRead) {
    builder.json["images"] = {{{"uri", "missing.png"}}};
    builder.json["textures"] = {{{"source", 0}}};
    EXPECT_TRUE(import_material(json::object()).warnings.empty());
}

TEST_F(MaterialImport, VeryWideImagesAreScaledDown) {
    const int texture = builder.add_texture(make_png(100000, 1, std::vector<std::uint8_t>(100000, 200), 1));
    const SceneData scene = import_material({{"emissiveTexture", {{"index", texture}}}});
    const Image& image = scene.images.at(0);
    EXPECT_EQ(image.width, 16384u);
    EXPECT_EQ(image.height, 1u);
    EXPECT_EQ(image.rgba[4 * 16383], 200);
    expect_warning(scene, "/images/0", "100000 x 1 texels");
}

// A vertex holds the two sets that its material uses; sets 0 and 1 keep their places.
TEST_F(MaterialImport, AnyTwoTextureCoordinateSets) {
    const int texture = builder.add_texture(white());
    const std::vector<float> places = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    json attributes = {{"POSITION", builder.add_vec3(places)}};
    for (int set = 0; set < 4; ++set) {
        const std::vector<float> uvs(6, static_cast<float>(set));
        attributes[fmt::format("TEXCOORD_{}", set)] = builder.add(uvs, "VEC2", 2);
    }
    const auto info = [&](int set) { return json{{"index", texture}, {"texCoord", set}}; };
    const std::vector<json> materials = {
        {{"emissiveTexture", info(3)}},
        {{"emissiveTexture", info(0)}, {"occlusionTexture", info(2)}},
        {{"emissiveTexture", info(1)}, {"occlusionTexture", info(3)}},
        {{"emissiveTexture", info(3)},
         {"occlusionTexture",
          {{"index", texture}, {"extensions", {{"KHR_texture_transform", {{"texCoord", 2}}}}}}}}};
    for (std::size_t i = 0; i < materials.size(); ++i) {
        builder.add_material(materials[i]);
        builder.add_primitive(attributes)["material"] = i;
    }
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty()) << testing::PrintToString(scene.warnings);
    ASSERT_EQ(scene.meshes.size(), 4u);
    const auto coordinate = [&](std::size_t i, const TextureRef& ref) {
        const Vertex& vertex = scene.meshes[i].vertices[0];
        return ref.present() ? (ref.uv_set == 0 ? vertex.uv0 : vertex.uv1).x : -1;
    };
    const std::pair<float, float> expected[] = {{3, -1}, {0, 2}, {1, 3}, {3, 2}};
    for (std::size_t i = 0; i < 4; ++i) {
        const Material& m = scene.materials[scene.meshes[i].material];
        EXPECT_EQ(coordinate(i, m.emissive_texture), expected[i].first) << i;
        EXPECT_EQ(coordinate(i, m.occlusion_texture), expected[i].second) << i;
    }
}

TEST_F(MaterialImport, ThirdTextureCoordinateSetOfAMaterialIsLeftOut) {
    const int texture = builder.add_texture(white());
    const auto info = [&](int set) { return json{{"index", texture}, {"texCoord", set}}; };
    const SceneData scene = import_material(
        {{"emissiveTexture", info(5)}, {"occlusionTexture", info(0)}, {"normalTexture", info(2)}});
    EXPECT_FALSE(scene.materials.at(0).emissive_texture.present());
    EXPECT_TRUE(scene.materials.at(0).normal_texture.present());
    EXPECT_TRUE(scene.materials.at(0).occlusion_texture.present());
    expect_warning(scene, "/materials/0", "TEXCOORD_5");
}

}  // namespace
}  // namespace lanthorn
