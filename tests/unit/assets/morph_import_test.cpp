// Morph targets: differences, weights, what the import does to vertices.
#include <limits>

#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace morph_import_test {

using nlohmann::json;

const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::vector<float> kUpNormals = {0, 0, 1, 0, 0, 1, 0, 0, 1};

class MorphImport : public ImportTest {
  protected:
    json& add_triangle_with_normals() {
        return builder.add_primitive(
            {{"POSITION", builder.add_vec3(kTriangle)}, {"NORMAL", builder.add_vec3(kUpNormals)}});
    }
};

TEST_F(MorphImport, DifferencesOfTheVerticesThatMove) {
    json& primitive = add_triangle_with_normals();
    primitive["targets"] = {{{"POSITION", builder.add_vec3({0, 0, 0, 0, 0, 1, 0, 0, 0})},
                             {"NORMAL", builder.add_vec3({0, 0, 0, 0, 0, 0, 1, 0, 0})},
                             {"TANGENT", builder.add_vec3({0, 0, 0, 0, 1, 0, 0, 0, 0})}},
                            {{"POSITION", builder.add_vec3({0, 0, 2, 0, 0, 0, 0, 0, 0})}}};
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.morphs.size(), 2u);
    const MorphTarget& first = mesh.morphs[0];
    EXPECT_EQ(first.vertices, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(first.positions, (std::vector<vec3>{vec3(0, 0, 1), vec3(0)}));
    EXPECT_EQ(first.normals, (std::vector<vec3>{vec3(0), vec3(1, 0, 0)}));
    EXPECT_EQ(first.tangents, (std::vector<vec3>{vec3(0, 1, 0), vec3(0)}));
    EXPECT_EQ(mesh.morphs[1].vertices, (std::vector<std::uint32_t>{0}));
    EXPECT_TRUE(mesh.morphs[1].normals.empty());
    EXPECT_TRUE(mesh.morphs[1].tangents.empty());
    EXPECT_EQ(mesh.morph_weights, (std::vector<float>{0, 0}));
    EXPECT_EQ(mesh.bounds.upper.z, 0);  // the mesh's own
}

TEST_F(MorphImport, SparseTargets) {
    json& primitive = add_triangle_with_normals();
    const int accessor = builder.add_accessor(-1, 5126, "VEC3", 3);
    const int where = builder.add_view(GltfBuilder::bytes_of(std::vector<std::uint8_t>{2}));
    const int what = builder.add_view(GltfBuilder::bytes_of(std::vector<float>{0, 0, 5}));
    builder.json["accessors"][static_cast<std::size_t>(accessor)]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", where}, {"componentType", 5121}}},
        {"values", {{"bufferView", what}}}};
    primitive["targets"] = {{{"POSITION", accessor}}};
    const SceneData scene = import();
    const MorphTarget& target = scene.meshes.at(0).morphs.at(0);
    EXPECT_EQ(target.vertices, (std::vector<std::uint32_t>{2}));
    EXPECT_EQ(target.positions, (std::vector<vec3>{vec3(0, 0, 5)}));
}

TEST_F(MorphImport, QuantisedDifferences) {
    json& primitive = add_triangle_with_normals();
    const std::vector<std::int8_t> values = {127, 0, -127, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    const int view = builder.add_view(GltfBuilder::bytes_of(values), 4);
    const int accessor = builder.add_accessor(view, 5120, "VEC3", 3);
    builder.json["accessors"][static_cast<std::size_t>(accessor)]["normalized"] = true;
    primitive["targets"] = {{{"POSITION", accessor}}};
    const SceneData scene = import();
    EXPECT_EQ(scene.meshes.at(0).morphs.at(0).positions, (std::vector<vec3>{vec3(1, 0, -1)}));
}

TEST_F(MorphImport, WeightsOfTheMeshAndOfTheNode) {
    json& primitive = add_triangle_with_normals();
    const int up = builder.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive["targets"] = {{{"POSITION", up}}, {{"POSITION", up}}};
    builder.json["meshes"][0]["weights"] = {0.5, 0.25};
    builder.json["nodes"].push_back({{"mesh", 0}, {"weights", {1, 0}}});
    const SceneData scene = import();
    EXPECT_EQ(scene.meshes[0].morph_weights, (std::vector<float>{0.5f, 0.25f}));
    EXPECT_TRUE(scene.nodes[0].morph_weights.empty());
    EXPECT_EQ(scene.nodes[1].morph_weights, (std::vector<float>{1, 0}));
}

TEST_F(MorphImport, WrongNumbersOfWeightsAreMended) {
    json& primitive = add_triangle_with_normals();
    primitive["targets"] = {{{"POSITION", builder.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1})}}};
    builder.json["meshes"][0]["weights"] = {0.5, 0.25};
    expect_warning(import(), "/meshes/0/weights", "found 2 weights, expected 1");
    builder.json["meshes"][0].erase("weights");
    builder.json["nodes"][0]["weights"] = json::array();
    expect_warning(import(), "/nodes/0/weights", "found 0 weights, expected 1");
    builder.json["nodes"][0]["weights"] = {"a"};
    expect_refused("/nodes/0/weights/0", "number");
}

// Flat normals give each corner its own vertex, and the differences follow; so do their normals.
TEST_F(MorphImport, DifferencesFollowTheirVerticesAndFlatNormalsFollowThem) {
    const std::vector<float> square = {9, 9, 9, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};  // the first is not used
    const int indices = builder.add_scalars<std::uint16_t>({1, 2, 3, 1, 3, 4});
    json& primitive = builder.add_primitive({{"POSITION", builder.add_vec3(square)}}, indices);
    // The last corner goes up: the second triangle alone is turned.
    primitive["targets"] = {{{"POSITION", builder.add_vec3({7, 7, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1})}}};
    const SceneData scene = import();
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.vertices.size(), 6u);
    const MorphTarget& target = mesh.morphs.at(0);
    EXPECT_EQ(target.vertices, (std::vector<std::uint32_t>{3, 4, 5}));
    EXPECT_EQ(target.positions, (std::vector<vec3>{vec3(0), vec3(0), vec3(0, 0, 1)}));
    const vec3 turned = glm::normalize(glm::cross(vec3(1, 1, 0), vec3(0, 1, 1)));
    for (const vec3& difference : target.normals) {
        expect_near(difference, turned - vec3(0, 0, 1));
    }
}

TEST_F(MorphImport, FlatTrianglesThatOpenStay) {
    json& primitive = builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, 1, 0, 0})}});
    primitive["targets"] = {{{"POSITION", builder.add_vec3({0, 0, 0, 0, 0, 0, 0, 1, 0})}}};
    const SceneData scene = import();
    EXPECT_EQ(scene.triangle_count(), 1u);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(MorphImport, DifferencesOfNormalsInPlainIntegersAreFractions) {
    json& primitive = add_triangle_with_normals();
    const std::vector<std::int8_t> values = {0, 127, -127, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    primitive["targets"] = {
        {{"NORMAL",
          builder.add_accessor(builder.add_view(GltfBuilder::bytes_of(values), 4), 5120, "VEC3", 3)}}};
    const SceneData scene = import();
    expect_warning(scene, "/meshes/0/primitives/0/targets/0/NORMAL", "read as fractions");
    EXPECT_EQ(scene.meshes.at(0).morphs.at(0).normals, (std::vector<vec3>{vec3(0, 1, -1)}));
}

TEST_F(MorphImport, DifferencesThatAreNotFinite) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    json& primitive = add_triangle_with_normals();
    const int broken = builder.add_vec3({0, 0, 1, 0, nan, 0, 0, 0, 0});
    primitive["targets"] = {{{"NORMAL", broken}}};
    const SceneData scene = import();
    expect_warning(scene, "/meshes/0/primitives/0/targets/0/NORMAL", "1 values");
    EXPECT_EQ(scene.meshes[0].morphs[0].vertices, (std::vector<std::uint32_t>{0}));
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", broken}}};
    const SceneData moved = import();
    expect_warning(moved, "/meshes/0/primitives/0/targets/0/POSITION", "1 values");
    EXPECT_EQ(moved.meshes[0].morphs[0].vertices, (std::vector<std::uint32_t>{0}));
}

TEST_F(MorphImport, WrongTargetsAreRefusedOrToldOf) {
    json& primitive = add_triangle_with_normals();
    primitive["targets"] = {{{"POSITION", builder.add_vec3({0, 0, 1})}}};
    expect_refused("/meshes/0/primitives/0/targets/0/POSITION", "1 elements, expected 3");
    json& again = builder.json["meshes"][0]["primitives"][0];
    again["targets"] = {{{"POSITION", 77}}};
    expect_refused("/meshes/0/primitives/0/targets/0/POSITION", "expected an index");
    again["targets"] = {{{"COLOR_0", 0}}};
    const SceneData scene = import();
    expect_warning(scene, "/meshes/0/primitives/0/targets/0/COLOR_0", "left out");
    EXPECT_EQ(scene.meshes[0].morphs.size(), 1u);
    EXPECT_TRUE(scene.meshes[0].morphs[0].vertices.empty());
}

}  // namespace morph_import_test
}  // namespace lanthorn
