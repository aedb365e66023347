// Integers of vertices that are not marked as normalised: read as what explains the file.
#include <cmath>

#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;

const std::string kAttributes = "/meshes/0/primitives/0/attributes/";

class IntegersImport : public ImportTest {
  protected:
    // The vertices of a triangle with the attribute, after one warning that it was read as fractions or none.
    std::vector<Vertex> vertices(const std::string& attribute, int accessor, bool warned) {
        builder.json.erase("meshes");
        builder.json.erase("nodes");
        json& primitive = builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})},
                                                 {"NORMAL", builder.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1})},
                                                 {attribute, accessor}});
        if (material >= 0) {
            primitive["material"] = material;
        }
        const SceneData scene = import();
        if (warned) {
            expect_warning(scene, kAttributes + attribute, "read as fractions");
        } else {
            EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
        }
        return scene.meshes.at(0).vertices;
    }
    template <typename T>
    std::vector<Vertex> coloured(const std::vector<T>& colours, bool warned) {
        const std::size_t components = colours.size() / 3;
        return vertices("COLOR_0", builder.add(colours, components == 3 ? "VEC3" : "VEC4", components),
                        warned);
    }
    // The first vertex's.
    template <typename T>
    vec2 uv(T u, T v, bool warned) {
        return vertices("TEXCOORD_0", builder.add(std::vector<T>{u, v, 0, 0, 1, 1}, "VEC2", 2), warned)[0]
            .uv0;
    }
    int material = -1;
};

TEST_F(IntegersImport, ColoursAreFractions) {
    using Shorts = std::vector<std::uint16_t>;
    using Bytes = std::vector<std::uint8_t>;
    const vec4 shorts = coloured(Shorts{32768, 16384, 65535, 65535, 0, 0, 0, 0, 0, 0, 0, 0}, true)[0].colour;
    EXPECT_NEAR(shorts.r, 0.5f, 1e-4f);
    EXPECT_NEAR(shorts.g, 0.25f, 1e-4f);
    EXPECT_EQ(shorts.b, 1);
    EXPECT_EQ(coloured(Bytes{51, 0, 255, 0, 0, 0, 0, 0, 0}, true)[0].colour, vec4(0.2f, 0, 1, 1))
        << "missing alpha is 1";
    // The darkest that there can be: nothing but fractions explains a 2.
    EXPECT_EQ(coloured(Bytes{2, 1, 0, 0, 0, 0, 0, 0, 0}, true)[0].colour, vec4(2 / 255.0f, 1 / 255.0f, 0, 1));
    EXPECT_EQ(coloured(std::vector<std::int8_t>{127, 0, 0, 0, 0, 0, 0, 0, 0}, true)[0].colour,
              vec4(1, 0, 0, 1));
}

TEST_F(IntegersImport, ColoursOfZeroAndOneAreNumbers) {
    const auto all = coloured(std::vector<std::uint8_t>{1, 0, 1, 0, 1, 0, 0, 0, 0}, false);
    EXPECT_EQ(all[0].colour, vec4(1, 0, 1, 1));
    EXPECT_EQ(all[1].colour, vec4(0, 1, 0, 1));
}

TEST_F(IntegersImport, ColoursOfBytesThatWereWrittenAsFloats) {
    builder.add_primitive(
        {{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})},
         {"COLOR_0", builder.add(std::vector<float>{51, 0, 255, 102, 0, 0, 0, 255, 0, 0, 0, 0}, "VEC4", 4)}});
    const SceneData scene = import();
    expect_warning(scene, kAttributes + "COLOR_0", "divided by 255");
    EXPECT_EQ(scene.meshes.at(0).vertices[0].colour, vec4(0.2f, 0, 1, 0.4f));
}

TEST_F(IntegersImport, TextureCoordinatesFarOutAreFractions) {
    EXPECT_EQ(uv<std::uint16_t>(65535, 13107, true), vec2(1, 0.2f));
    EXPECT_EQ(uv<std::uint8_t>(51, 255, true), vec2(0.2f, 1));
    EXPECT_NEAR((uv<std::int16_t>(-32767, 16384, true).y), 0.5f, 1e-4f);
    EXPECT_EQ(uv<std::uint8_t>(17, 0, true).x, 17 / 255.0f);
}

TEST_F(IntegersImport, TextureCoordinatesOfAFewTurnsAreNumbers) {
    EXPECT_EQ(uv<std::uint8_t>(15, 4, false), vec2(15, 4));
    EXPECT_EQ(uv<std::uint16_t>(4095, 1, false), vec2(4095, 1));
    EXPECT_EQ(uv<std::int8_t>(-7, 3, false), vec2(-7, 3));
}

TEST_F(IntegersImport, QuantisedTextureCoordinatesAreNumbers) {
    builder.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    EXPECT_EQ(uv<std::uint16_t>(65535, 13107, false), vec2(65535, 13107));
    builder.json["extensionsUsed"] = {"KHR_texture_transform"};
    const int texture = builder.add_texture(make_png(1, 1, {1, 2, 3}, 3));
    const json transform = {{"scale", {1 / 4096.0, 1 / 4096.0}}};
    material = builder.add_material(
        {{"pbrMetallicRoughness",
          {{"baseColorTexture",
            {{"index", texture}, {"extensions", {{"KHR_texture_transform", transform}}}}}}}});
    EXPECT_EQ(uv<std::uint16_t>(4096, 8192, false), vec2(4096, 8192));
}

class SkinIntegers : public ImportTest {
  protected:
    // A triangle in a skin of two joints; the first vertex's influences.
    SkinInfluences influences(int joints, int weights, const std::string& place, const std::string& part) {
        builder.json.erase("meshes");
        builder.json["nodes"] = json::array();
        builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})},
                               {"NORMAL", builder.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1})},
                               {"JOINTS_0", joints},
                               {"WEIGHTS_0", weights}});
        builder.json["nodes"][0]["skin"] = 0;
        builder.json["nodes"].push_back({{"children", {2}}});
        builder.json["nodes"].push_back(json::object());
        builder.json["skins"] = {{{"joints", {2, 1}}}};
        const SceneData scene = import();
        expect_warning(scene, kAttributes + place, part);
        return scene.meshes.at(0).skin.at(0);
    }
    template <typename T>
    int vec4s(const std::vector<T>& first) {
        std::vector<T> all = first;
        all.insert(all.end(), {1, 0, 0, 0, 1, 0, 0, 0});
        return builder.add(all, "VEC4", 4);
    }
};

TEST_F(SkinIntegers, WeightsAreFractionsOfTheirSum) {
    const int joints = vec4s<std::uint8_t>({0, 1, 0, 0});
    const auto expect_quarters = [&](int weights) {
        const SkinInfluences first = influences(joints, weights, "WEIGHTS_0", "read as fractions");
        EXPECT_EQ(first.joints[0], 1);
        EXPECT_NEAR(first.weights[0], 0.75f, 1e-6f);
        EXPECT_NEAR(first.weights[1], 0.25f, 1e-6f);
    };
    expect_quarters(vec4s<std::uint8_t>({64, 192, 0, 0}));
    expect_quarters(vec4s<std::uint16_t>({16384, 49152, 0, 0}));
    expect_quarters(vec4s<std::uint8_t>({1, 3, 0, 0}));
    expect_quarters(vec4s<std::int16_t>({5000, 15000, 0, 0}));
}

TEST_F(SkinIntegers, JointsOfAnyTypeAreWholeNumbers) {
    const int weights = vec4s<float>({0.25f, 0.75f, 0, 0});
    const auto expect_joints = [&](int joints, const char* part) {
        const SkinInfluences first = influences(joints, weights, "JOINTS_0", part);
        EXPECT_EQ(first.joints[0], 1);
        EXPECT_EQ(first.joints[1], 0);
    };
    expect_joints(vec4s<float>({0, 1, 0, 0}), "read as whole numbers");
    expect_joints(vec4s<std::uint32_t>({0, 1, 0, 0}), "read as whole numbers");
    expect_joints(vec4s<std::int16_t>({0, 1, 0, 0}), "read as whole numbers");
    const int marked = vec4s<std::uint8_t>({0, 1, 0, 0});
    builder.json["accessors"].back()["normalized"] = true;
    expect_joints(marked, "'normalized' says nothing of joints");
}

}  // namespace
}  // namespace lanthorn
