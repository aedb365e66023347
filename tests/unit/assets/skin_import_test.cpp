// Skins: joints, weights, inverse bind matrices, and what is wrong with them.
#include <limits>

#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace skin_import_test {

using nlohmann::json;

const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::vector<float> kUpNormals = {0, 0, 1, 0, 0, 1, 0, 0, 1};

class SkinImport : public ImportTest {
  protected:
    // Node 0 shows a triangle with normals in skin 0, whose joints are nodes 1 and 2.
    json& add_skinned(const std::vector<std::uint8_t>& joints, const std::vector<float>& weights) {
        json& primitive = builder.add_primitive({{"POSITION", builder.add_vec3(kTriangle)},
                                                 {"NORMAL", builder.add_vec3(kUpNormals)},
                                                 {"JOINTS_0", builder.add(joints, "VEC4", 4)},
                                                 {"WEIGHTS_0", builder.add(weights, "VEC4", 4)}});
        add_skin();
        return primitive;
    }
    void add_skin() {
        builder.json["nodes"][0]["skin"] = 0;
        builder.json["nodes"].push_back({{"name", "hip"}, {"children", {2}}});
        builder.json["nodes"].push_back({{"name", "knee"}});
        builder.json["skins"] = {{{"joints", {2, 1}}, {"name", "leg"}}};
    }
};

TEST_F(SkinImport, JointsAreNodesOfTheScene) {
    add_skinned({0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, {0.25f, 0.75f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    ASSERT_EQ(scene.skins.size(), 1u);
    EXPECT_EQ(scene.skins[0].name, "leg");
    ASSERT_EQ(scene.skins[0].joints.size(), 2u);
    EXPECT_EQ(scene.nodes[scene.skins[0].joints[0]].name, "knee");
    EXPECT_EQ(scene.nodes[scene.skins[0].joints[1]].name, "hip");
    EXPECT_EQ(scene.nodes[0].skin, 0u);
    EXPECT_EQ(scene.nodes[1].skin, kNone);
    const auto& skin = scene.meshes.at(0).skin;
    EXPECT_EQ(skin[0].joints[0], 1);  // the largest first
    EXPECT_FLOAT_EQ(skin[0].weights[0], 0.75f);
    EXPECT_EQ(skin[0].joints[1], 0);
    EXPECT_FLOAT_EQ(skin[0].weights[1], 0.25f);
    EXPECT_EQ(skin[0].weights[2], 0);
    EXPECT_EQ(skin[1].joints[0], 1);
}

TEST_F(SkinImport, MissingInverseBindMatricesAreTheIdentity) {
    add_skinned(std::vector<std::uint8_t>(12, 0), {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const SceneData scene = import();
    for (const mat4& matrix : scene.skins.at(0).inverse_binds) {
        EXPECT_EQ(matrix, mat4(1));
    }
}

TEST_F(SkinImport, InverseBindMatricesAreColumnMajor) {
    add_skinned(std::vector<std::uint8_t>(12, 0), {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const std::vector<float> matrices = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1,
                                         2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1};
    builder.json["skins"][0]["inverseBindMatrices"] = builder.add(matrices, "MAT4", 16);
    const SceneData scene = import();
    EXPECT_EQ(vec3(scene.skins.at(0).inverse_binds[0][3]), vec3(5, 6, 7));
    EXPECT_EQ(scene.skins[0].inverse_binds[1][1][1], 2);
}

TEST_F(SkinImport, WeightsAreDividedByTheirSum) {
    add_skinned({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, {2, 6, 0, 0, 0.1f, 0.1f, 0, 0, 1, 1, 0, 0});
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_FLOAT_EQ(scene.meshes[0].skin[0].weights[0], 0.75f);
    EXPECT_FLOAT_EQ(scene.meshes[0].skin[1].weights[0], 0.5f);
    EXPECT_FLOAT_EQ(scene.meshes[0].skin[1].weights[1], 0.5f);
}

TEST_F(SkinImport, QuantisedWeightsAndEightInfluences) {
    json& primitive = add_skinned({0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 2, 3, 4, 1, 0, 0, 0, 1, 0, 0, 0});
    const std::vector<std::uint16_t> more_joints = {1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    primitive["attributes"]["JOINTS_1"] = builder.add(more_joints, "VEC4", 4);
    const std::vector<std::uint8_t> more = {255, 0, 0, 51, 0, 0, 0, 0, 0, 0, 0, 0};  // 1 and 0.2
    primitive["attributes"]["WEIGHTS_1"] = builder.add(more, "VEC4", 4);
    builder.json["accessors"].back()["normalized"] = true;
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    const SkinInfluences& first = scene.meshes[0].skin[0];
    const std::array<float, 8> expected = {4 / 11.2f, 3 / 11.2f,    2 / 11.2f, 1 / 11.2f,
                                           1 / 11.2f, 0.2f / 11.2f, 0,         0};
    for (std::size_t k = 0; k < 8; ++k) {
        EXPECT_NEAR(first.weights[k], expected[k], 1e-7);
    }
    EXPECT_EQ(first.joints, (std::array<std::uint16_t, 8>{1, 0, 1, 0, 1, 0, 0, 0}));
}

TEST_F(SkinImport, OfMoreThanEightTheLargestStay) {
    json& primitive = add_skinned({0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0}, {9, 8, 7, 6, 1, 0, 0, 0, 1, 0, 0, 0});
    for (const char* set : {"1", "2"}) {
        const std::vector<std::uint8_t> joints = {1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0};
        const float scale = set[0] == '1' ? 1.0f : 10.0f;
        const std::vector<float> weights = {1 * scale, 2 * scale, 3 * scale, 4 * scale, 0, 0,
                                            0,         0,         0,         0,         0, 0};
        primitive["attributes"][std::string("JOINTS_") + set] = builder.add(joints, "VEC4", 4);
        primitive["attributes"][std::string("WEIGHTS_") + set] = builder.add(weights, "VEC4", 4);
    }
    const SceneData scene = import();
    expect_warning(scene, "/meshes/0/primitives/0/attributes/WEIGHTS_0", "1 vertices have more than 8");
    const float sum = 40 + 30 + 20 + 10 + 9 + 8 + 7 + 6;
    EXPECT_FLOAT_EQ(scene.meshes[0].skin[0].weights[0], 40 / sum);
    EXPECT_FLOAT_EQ(scene.meshes[0].skin[0].weights[7], 6 / sum);
}

TEST_F(SkinImport, WeightsAllZeroBindToTheFirstJoint) {
    add_skinned({1, 1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const SceneData scene = import();
    expect_warning(scene, "/meshes/0/primitives/0/attributes/WEIGHTS_0", "1 vertices are all zero");
    EXPECT_EQ(scene.meshes[0].skin[0].joints[0], 0);
    EXPECT_EQ(scene.meshes[0].skin[0].weights[0], 1);
}

TEST_F(SkinImport, NegativeAndNanWeightsAreZero) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    add_skinned({0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}, {-1, 1, 0, 0, nan, 2, 0, 0, 1, 0, 0, 0});
    const SceneData scene = import();
    expect_warning(scene, "/meshes/0/primitives/0/attributes/WEIGHTS_0", "2 weights");
    EXPECT_EQ(scene.meshes[0].skin[0].joints[0], 1);
    EXPECT_EQ(scene.meshes[0].skin[1].weights[0], 1);
}

TEST_F(SkinImport, JointOutOfRangeIsRefused) {
    add_skinned({0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 1, 0, 0, 0});
    expect_refused("/meshes/0/primitives/0/attributes/JOINTS_0",
                   "vertex 1 is bound to joint 2, expected an index below 2");
}

TEST_F(SkinImport, JointOutOfRangeWithoutWeightMeansNothing) {
    add_skinned({0, 99, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const SceneData scene = import();
    EXPECT_EQ(scene.meshes[0].skin[0].joints[1], 0);
}

TEST_F(SkinImport, WrongTypesAreRefused) {
    json& primitive = add_skinned(std::vector<std::uint8_t>(12, 0), std::vector<float>(12, 1));
    const json good = primitive["attributes"];
    primitive["attributes"]["JOINTS_0"] = good["POSITION"];
    expect_refused("/meshes/0/primitives/0/attributes/JOINTS_0", "5121, 5123");
    for (const float joint : {0.5f, -1.0f, 65536.0f, std::numeric_limits<float>::quiet_NaN()}) {
        const int halves = builder.add(std::vector<float>(12, joint), "VEC4", 4);
        primitive["attributes"]["JOINTS_0"] = halves;
        expect_refused("/accessors/" + std::to_string(halves), "expected a whole number of 0 to 65535");
    }
    primitive["attributes"] = good;
    primitive["attributes"]["WEIGHTS_0"] = good["POSITION"];
    expect_refused("/meshes/0/primitives/0/attributes/WEIGHTS_0", "normalised");
    primitive["attributes"] = good;
    primitive["attributes"]["JOINTS_0"] = builder.add(std::vector<std::uint8_t>(8, 0), "VEC4", 4);
    expect_refused("/meshes/0/primitives/0/attributes/JOINTS_0", "2 elements, expected 3");
}

TEST_F(SkinImport, BrokenInverseBindMatricesAreRefused) {
    add_skinned(std::vector<std::uint8_t>(12, 0), std::vector<float>(12, 1));
    json& skin = builder.json["skins"][0];
    std::vector<float> matrices(32, 0.0f);
    skin["inverseBindMatrices"] = builder.add(std::vector<float>(16, 0), "MAT4", 16);
    expect_refused("/skins/0/inverseBindMatrices", "1 elements, expected at least 2");
    skin["inverseBindMatrices"] = builder.add_vec3(kTriangle);
    expect_refused("/skins/0/inverseBindMatrices", "no MAT4");
    matrices[20] = std::numeric_limits<float>::quiet_NaN();
    const int accessor = builder.add(matrices, "MAT4", 16);
    skin["inverseBindMatrices"] = accessor;
    expect_refused("/accessors/" + std::to_string(accessor), "element 1 is nan (component 4)");
}

TEST_F(SkinImport, ProjectiveInverseBindMatricesAreMended) {
    add_skinned(std::vector<std::uint8_t>(12, 0), std::vector<float>(12, 1));
    std::vector<float> matrices(32, 1.0f);
    builder.json["skins"][0]["inverseBindMatrices"] = builder.add(matrices, "MAT4", 16);
    const SceneData scene = import();
    expect_warning(scene, "/skins/0/inverseBindMatrices", "fourth rows of 2 matrices");
    EXPECT_EQ(scene.skins[0].inverse_binds[1][0][3], 0);
    EXPECT_EQ(scene.skins[0].inverse_binds[1][3][3], 1);
}

TEST_F(SkinImport, SkinsWithoutJointsAndDanglingReferencesAreRefused) {
    add_skinned(std::vector<std::uint8_t>(12, 0), std::vector<float>(12, 1));
    const json good = builder.json;
    builder.json["skins"][0]["joints"] = json::array();
    expect_refused("/skins/0/joints", "found no joints");
    builder.json = good;
    builder.json["skins"][0].erase("joints");
    expect_refused("/skins/0/joints");
    builder.json = good;
    builder.json["skins"][0]["joints"] = {1, 7};
    expect_refused("/skins/0/joints/1", "expected an index below 3");
    builder.json = good;
    builder.json["nodes"][0]["skin"] = 1;
    expect_refused("/nodes/0/skin");
}

TEST_F(SkinImport, JointsOutsideTheSceneLeaveTheSkinOut) {
    add_skinned(std::vector<std::uint8_t>(12, 0), std::vector<float>(12, 1));
    builder.json["scenes"] = {{{"nodes", {0}}}};
    const SceneData scene = import();
    expect_warning(scene, "/skins/0/joints/0", "node 2 is not in the scene");
    EXPECT_EQ(scene.nodes.at(0).skin, kNone);
    EXPECT_TRUE(scene.skins.empty());
}

TEST_F(SkinImport, AMeshWithoutInfluencesIsNotSkinned) {
    builder.add_triangle();
    add_skin();
    const SceneData scene = import();
    expect_warning(scene, "/nodes/0/skin", "JOINTS_0 and WEIGHTS_0");
    EXPECT_EQ(scene.nodes[0].skin, kNone);
}

// glTF 2.0, 3.7.3.3: without a skin, joints mean nothing.
TEST_F(SkinImport, InfluencesWithoutASkinAreNotRead) {
    add_skinned(std::vector<std::uint8_t>(12, 9), std::vector<float>(12, 1));
    builder.json["nodes"][0].erase("skin");
    const SceneData scene = import();
    EXPECT_TRUE(scene.meshes[0].skin.empty());
    EXPECT_TRUE(scene.skins.empty());
}

// Flat normals give each corner its own vertex; its influences come along.
TEST_F(SkinImport, InfluencesFollowTheirVertices) {
    const std::vector<float> square = {9, 9, 9, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};  // the first is not used
    std::vector<std::uint8_t> joints(20, 0);
    std::vector<float> weights(20, 0);
    for (std::size_t v = 0; v < 5; ++v) {
        weights[v * 4] = static_cast<float>(v) / 16;
        weights[v * 4 + 1] = 1 - static_cast<float>(v) / 16;
        joints[v * 4 + 1] = 1;
    }
    const int indices = builder.add_scalars<std::uint16_t>({1, 2, 3, 1, 3, 4});
    builder.add_primitive({{"POSITION", builder.add_vec3(square)},
                           {"JOINTS_0", builder.add(joints, "VEC4", 4)},
                           {"WEIGHTS_0", builder.add(weights, "VEC4", 4)}},
                          indices);
    add_skin();
    const SceneData scene = import();
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.vertices.size(), 6u);
    const std::array<std::size_t, 6> from = {1, 2, 3, 1, 3, 4};
    for (std::size_t v = 0; v < 6; ++v) {
        EXPECT_EQ(mesh.vertices[v].position.x, square[from[v] * 3]);
        EXPECT_FLOAT_EQ(mesh.skin[v].weights[0], 1 - static_cast<float>(from[v]) / 16);
        EXPECT_EQ(mesh.skin[v].joints[0], 1);
    }
}

// A triangle without area in the bind pose may get one when its joints part.
TEST_F(SkinImport, FlatTrianglesBetweenJointsStay) {
    const std::vector<float> line = {0, 0, 0, 1, 0, 0, 2, 0, 0};
    const std::vector<std::uint8_t> joints = {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0};
    const std::vector<float> weights = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    builder.add_primitive({{"POSITION", builder.add_vec3(line)},
                           {"JOINTS_0", builder.add(joints, "VEC4", 4)},
                           {"WEIGHTS_0", builder.add(weights, "VEC4", 4)}});
    add_skin();
    EXPECT_EQ(import().triangle_count(), 1u);
}

}  // namespace skin_import_test
}  // namespace lanthorn
