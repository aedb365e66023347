// Geometry: topologies, index types, layouts, encodings, generated normals and tangents.
#include <array>
#include <limits>

#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;

class MeshImport : public ImportTest {};

using Triangle = std::array<vec3, 3>;

Triangle triangle(const Mesh& mesh, std::size_t index) {
    Triangle corners;
    for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = mesh.vertices[mesh.indices[index * 3 + k]].position;
    }
    return corners;
}

// A unit square of 4 vertices in the order of a strip: (0,0) (1,0) (0,1) (1,1).
const std::vector<float> kStrip = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
const std::vector<float> kUpNormals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

TEST_F(MeshImport, TriangleListWithoutIndices) {
    builder.add_triangle();
    const SceneData scene = import();
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.triangle_count(), 1u);
    EXPECT_EQ(triangle(scene.meshes[0], 0), (Triangle{vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0)}));
    EXPECT_EQ(scene.meshes[0].bounds, (Aabb{vec3(0), vec3(1, 1, 0)}));
    EXPECT_TRUE(scene.warnings.empty());
}

// All triangles of a strip and a fan face the same way.
TEST_F(MeshImport, StripsAndFansKeepTheirWinding) {
    builder.add_primitive({{"POSITION", builder.add_vec3(kStrip)}})["mode"] = 5;
    builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})}})["mode"] = 6;
    const SceneData scene = import();
    ASSERT_EQ(scene.meshes.size(), 2u);
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_EQ(mesh.indices.size(), 6u);
        float area = 0;
        for (std::size_t t = 0; t < 2; ++t) {
            const Triangle c = triangle(mesh, t);
            const vec3 cross = glm::cross(c[1] - c[0], c[2] - c[0]);
            EXPECT_GT(cross.z, 0);
            area += cross.z / 2;
        }
        EXPECT_FLOAT_EQ(area, 1);
    }
}

TEST_F(MeshImport, PointsAndLinesAreThinSurfaces) {
    const std::pair<int, std::size_t> shapes_by_mode[] = {{0, 3}, {1, 1}, {2, 3}, {3, 2}};
    for (const auto& [mode, shapes] : shapes_by_mode) {
        builder = GltfBuilder();
        json& primitive = builder.add_primitive({{"POSITION", builder.add_vec3(kTriangle)}});
        primitive["mode"] = mode;
        const SceneData scene = import();
        expect_warning(scene, "/meshes/0/primitives/0", mode == 0 ? "drawn as octahedra" : "drawn as rods");
        ASSERT_EQ(scene.meshes.size(), 1u);
        const Mesh& mesh = scene.meshes[0];
        EXPECT_EQ(mesh.indices.size() / 3, 8 * shapes) << mode;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto at = [&](std::size_t c) { return mesh.vertices[mesh.indices[i + c]]; };
            const vec3 out = glm::cross(at(1).position - at(0).position, at(2).position - at(0).position);
            EXPECT_GT(glm::dot(out, at(0).normal + at(1).normal + at(2).normal), 0) << "seen from outside";
        }
        EXPECT_LT(mesh.bounds.upper.x, 1.01f);
        EXPECT_LT(mesh.bounds.upper.z, 0.01f);
    }
}

TEST_F(MeshImport, LinesFollowTheirMorphTargets) {
    json& primitive = builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0})}});
    primitive["mode"] = 1;
    primitive["targets"] = {{{"POSITION", builder.add_vec3({0, 0, 0, 0, 5, 0})}}};
    const Mesh mesh = import().meshes.at(0);
    ASSERT_EQ(mesh.morphs.size(), 1u);
    EXPECT_EQ(mesh.morphs[0].vertices, (std::vector<std::uint32_t>{4, 5, 6, 7})) << "the far end";
}

TEST_F(MeshImport, IndicesOfEveryType) {
    const int positions = builder.add_vec3(kStrip);
    builder.add_primitive({{"POSITION", positions}}, builder.add_scalars<std::uint8_t>({0, 1, 3}));
    builder.add_primitive({{"POSITION", positions}}, builder.add_scalars<std::uint16_t>({0, 1, 3}));
    builder.add_primitive({{"POSITION", positions}}, builder.add_scalars<std::uint32_t>({0, 1, 3}));
    const SceneData scene = import();
    ASSERT_EQ(scene.meshes.size(), 3u);
    for (const Mesh& mesh : scene.meshes) {
        EXPECT_EQ(triangle(mesh, 0), (Triangle{vec3(0, 0, 0), vec3(1, 0, 0), vec3(1, 1, 0)}));
        EXPECT_EQ(mesh.vertices.size(), 3u) << "the unused vertex stays";
    }
}

TEST_F(MeshImport, IndexOutOfRangeIsRefused) {
    const int positions = builder.add_vec3(kTriangle);
    builder.add_primitive({{"POSITION", positions}}, builder.add_scalars<std::uint16_t>({0, 1, 3}));
    expect_refused("/accessors/1", "element 2 is 3, expected a vertex index below 3");
}

TEST_F(MeshImport, PrimitiveRestartIsRefused) {
    const int positions = builder.add_accessor(-1, 5126, "VEC3", 256);
    builder.add_primitive({{"POSITION", positions}}, builder.add_scalars<std::uint8_t>({0, 1, 255}));
    expect_refused("/accessors/1", "element 2 is 255 (primitive restart)");
}

TEST_F(MeshImport, FloatIndicesAreRefused) {
    builder.add_primitive({{"POSITION", builder.add_vec3(kTriangle)}}, builder.add_scalars<float>({0, 1, 2}));
    expect_refused("/meshes/0/primitives/0/indices", "unsigned integers");
}

TEST_F(MeshImport, CornersThatAreNoMultipleOfThree) {
    builder.add_primitive({{"POSITION", builder.add_vec3(kStrip)}});
    const SceneData scene = import();
    EXPECT_EQ(scene.triangle_count(), 1u);
    expect_warning(scene, "/meshes/0/primitives/0", "multiple of 3");
}

TEST_F(MeshImport, InterleavedAttributes) {
    // position, normal, texture coordinates: 32 bytes a vertex
    const int view = builder.add_view(GltfBuilder::bytes_of<float>({0, 0, 0, 0, 0, 1, 0.25f, 0.5f,  //
                                                                    1, 0, 0, 0, 0, 1, 0.75f, 0.5f,  //
                                                                    0, 1, 0, 0, 0, 1, 0.25f, 1.0f}),
                                      32);
    const int positions = builder.add_accessor(view, 5126, "VEC3", 3);
    const int normals = builder.add_accessor(view, 5126, "VEC3", 3);
    const int uvs = builder.add_accessor(view, 5126, "VEC2", 3);
    builder.json["accessors"][1]["byteOffset"] = 12;
    builder.json["accessors"][2]["byteOffset"] = 24;
    builder.add_primitive({{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}});
    const SceneData scene = import();
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.vertices[1].position, vec3(1, 0, 0));
    EXPECT_EQ(mesh.vertices[1].normal, vec3(0, 0, 1));
    EXPECT_EQ(mesh.vertices[1].uv0, vec2(0.75f, 0.5f));
    EXPECT_EQ(mesh.vertices[2].uv0, vec2(0.25f, 1.0f));
}

TEST_F(MeshImport, SparseSubstitution) {
    const int positions = builder.add_vec3(kTriangle);
    builder.json["accessors"][positions]["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", builder.add_view(GltfBuilder::bytes_of<std::uint8_t>({2}))},
          {"componentType", 5121}}},
        {"values", {{"bufferView", builder.add_view(GltfBuilder::bytes_of<float>({0, 5, 0}))}}}};
    builder.add_primitive({{"POSITION", positions}});
    EXPECT_EQ(triangle(import().meshes.at(0), 0), (Triangle{vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 5, 0)}));
}

TEST_F(MeshImport, SparseWithoutBaseForPositionsAndIndices) {
    const int positions = builder.add_accessor(-1, 5126, "VEC3", 3);
    const int indices = builder.add_accessor(-1, 5123, "SCALAR", 3);
    const int ones = builder.add_view(GltfBuilder::bytes_of<std::uint16_t>({1, 2}));
    builder.json["accessors"][positions]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", ones}, {"componentType", 5123}}},
        {"values", {{"bufferView", builder.add_view(GltfBuilder::bytes_of<float>({2, 0, 0, 0, 2, 0}))}}}};
    builder.json["accessors"][indices]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", ones}, {"componentType", 5123}}},
        {"values", {{"bufferView", ones}}}};
    builder.add_primitive({{"POSITION", positions}}, indices);
    EXPECT_EQ(triangle(import().meshes.at(0), 0), (Triangle{vec3(0, 0, 0), vec3(2, 0, 0), vec3(0, 2, 0)}));
}

TEST_F(MeshImport, SparseIndexOutOfRangeIsRefused) {
    const int positions = builder.add_vec3(kTriangle);
    builder.json["accessors"][positions]["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", builder.add_view(GltfBuilder::bytes_of<std::uint8_t>({3}))},
          {"componentType", 5121}}},
        {"values", {{"bufferView", builder.add_view(GltfBuilder::bytes_of<float>({0, 5, 0}))}}}};
    builder.add_primitive({{"POSITION", positions}});
    expect_refused("/accessors/0/sparse/indices", "element 0 is 3");
}

// KHR_mesh_quantization: integer positions as numbers, normalised normals, unsigned and signed texture
// coordinates.
TEST_F(MeshImport, QuantisedAttributes) {
    builder.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const int positions = builder.add_accessor(
        builder.add_view(GltfBuilder::bytes_of<std::int16_t>({0, 0, 0, 0, 100, 0, 0, 0, 0, -50, 0, 0}), 8),
        5122, "VEC3", 3);
    const int normals = builder.add_accessor(
        builder.add_view(GltfBuilder::bytes_of<std::int8_t>({0, 0, 127, 0, 0, 0, 127, 0, 0, 0, -128, 0}), 4),
        5120, "VEC3", 3);
    const int uvs = builder.add_accessor(
        builder.add_view(GltfBuilder::bytes_of<std::uint16_t>({0, 65535, 32768, 0, 65535, 65535})), 5123,
        "VEC2", 3);
    const int uvs1 = builder.add_accessor(
        builder.add_view(GltfBuilder::bytes_of<std::int16_t>({3, 0, -4, 0, 0, 7})), 5122, "VEC2", 3);
    builder.json["accessors"][normals]["normalized"] = true;
    builder.json["accessors"][uvs]["normalized"] = true;
    builder.add_primitive(
        {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}, {"TEXCOORD_1", uvs1}});
    const SceneData scene = import();
    const std::vector<Vertex>& v = scene.meshes.at(0).vertices;
    EXPECT_EQ(v[1].position, vec3(100, 0, 0));
    EXPECT_EQ(v[2].position, vec3(0, -50, 0));
    EXPECT_EQ(v[0].normal, vec3(0, 0, 1));
    EXPECT_EQ(v[2].normal, vec3(0, 0, -1)) << "-128 clamps to -1";
    EXPECT_EQ(v[0].uv0, vec2(0, 1));
    EXPECT_NEAR(v[1].uv0.x, 32768 / 65535.0, 1e-7);
    EXPECT_EQ(v[1].uv1, vec2(-4, 0));
    EXPECT_EQ(v[2].uv1, vec2(0, 7));
}

TEST_F(MeshImport, ColoursOfThreeAndFourComponents) {
    const int positions = builder.add_vec3(kTriangle);
    const int bytes = builder.add<std::uint8_t>({255, 0, 51, 255, 255, 0, 51, 0, 255, 0, 51, 102}, "VEC4", 4);
    builder.json["accessors"][bytes]["normalized"] = true;
    builder.add_primitive(
        {{"POSITION", positions}, {"COLOR_0", builder.add_vec3({1, 0.5f, 0, 1, 1, 1, 0, 0, 0})}});
    builder.add_primitive({{"POSITION", positions}, {"COLOR_0", bytes}});
    const SceneData scene = import();
    EXPECT_EQ(scene.meshes.at(0).vertices[0].colour, vec4(1, 0.5f, 0, 1)) << "missing alpha is 1";
    EXPECT_EQ(scene.meshes.at(1).vertices[2].colour, vec4(1, 0, 0.2f, 0.4f));
}

TEST_F(MeshImport, ColoursOutsideTheirRangeAreClamped) {
    builder.add_primitive({{"POSITION", builder.add_vec3(kTriangle)},
                           {"COLOR_0", builder.add_vec3({2, -1, std::nanf(""), 1, 1, 1, 0, 0, 0})}});
    const SceneData scene = import();
    EXPECT_EQ(scene.meshes.at(0).vertices[0].colour, vec4(1, 0, 0, 1));
    expect_warning(scene, "/meshes/0/primitives/0/attributes/COLOR_0", "3 values");
}

// glTF 2.0, 3.7.2.1: flat normals, so the shared corners of a folded sheet come apart.
TEST_F(MeshImport, MissingNormalsBecomeFlat) {
    builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1})}},
                          builder.add_scalars<std::uint8_t>({0, 1, 2, 0, 3, 1}));
    const SceneData scene = import();
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.vertices.size(), 6u);
    for (std::size_t k = 0; k < 3; ++k) {
        expect_near(mesh.vertices[mesh.indices[k]].normal, vec3(0, 0, 1));
        expect_near(mesh.vertices[mesh.indices[3 + k]].normal, vec3(0, -1, 0));
    }
}

TEST_F(MeshImport, ZeroAndNanNormalsAreReplacedByTheSurfaces) {
    const float nan = std::nanf("");
    builder.add_primitive({{"POSITION", builder.add_vec3(kTriangle)},
                           {"NORMAL", builder.add_vec3({0, 0, 0, nan, 0, 1, 0, 0, 5})}});
    const SceneData scene = import();
    for (const Vertex& vertex : scene.meshes.at(0).vertices) {
        EXPECT_EQ(vertex.normal, vec3(0, 0, 1));
    }
    expect_warning(scene, "/meshes/0/primitives/0/attributes/NORMAL", "2 zero normals");
}

TEST_F(MeshImport, NormalsOfAnyLengthAreNormalised) {
    builder.add_primitive({{"POSITION", builder.add_vec3(kTriangle)},
                           {"NORMAL", builder.add_vec3({0, 0, 1e-30f, 0, 3e38f, 0, 1e-40f, 0, 0})}});
    const std::vector<Vertex> v = import().meshes.at(0).vertices;
    expect_near(v[0].normal, vec3(0, 0, 1));
    expect_near(v[1].normal, vec3(0, 1, 0));
    expect_near(v[2].normal, vec3(1, 0, 0));
}

TEST_F(MeshImport, UnusableTangentsAreReplaced) {
    builder.add_primitive(
        {{"POSITION", builder.add_vec3(kTriangle)},
         {"NORMAL", builder.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1})},
         {"TANGENT", builder.add<float>({2, 0, 0, -1, 0, 0, 1, 1, 0, 0, 0, 0}, "VEC4", 4)}});
    const SceneData scene = import();
    const std::vector<Vertex>& v = scene.meshes.at(0).vertices;
    EXPECT_EQ(v[0].tangent, vec4(1, 0, 0, -1));
    EXPECT_NEAR(glm::dot(v[1].normal, vec3(v[1].tangent)), 0, 1e-6);
    expect_warning(scene, "/meshes/0/primitives/0/attributes/TANGENT", "2 unusable");
}

class TangentImport : public MeshImport {
  protected:
    // A square in the XY plane seen from +Z, textured by `uvs`, with a normal map.
    Mesh square(const std::vector<float>& uvs, int uv_set = 0) {
        const int texture = builder.add_texture(make_png(1, 1, {128, 128, 255}, 3));
        const int material =
            builder.add_material({{"normalTexture", {{"index", texture}, {"texCoord", uv_set}}}});
        json& primitive =
            builder.add_primitive({{"POSITION", builder.add_vec3(kStrip)},
                                   {"NORMAL", builder.add_vec3(kUpNormals)},
                                   {uv_set == 0 ? "TEXCOORD_0" : "TEXCOORD_1", builder.add(uvs, "VEC2", 2)}});
        primitive["mode"] = 5;
        primitive["material"] = material;
        return import().meshes.at(0);
    }
};

// The picture upright: U to the right, V down, so that the bitangent (the picture's up) is +Y.
TEST_F(TangentImport, UprightTexture) {
    for (const Vertex& vertex : square({0, 1, 1, 1, 0, 0, 1, 0}).vertices) {
        expect_near(vec3(vertex.tangent), vec3(1, 0, 0));
        EXPECT_EQ(vertex.tangent.w, 1);
    }
}

TEST_F(TangentImport, MirroredTextureOfTheSecondSet) {
    for (const Vertex& vertex : square({1, 1, 0, 1, 1, 0, 0, 0}, 1).vertices) {
        expect_near(vec3(vertex.tangent), vec3(-1, 0, 0));
        EXPECT_EQ(vertex.tangent.w, -1);
    }
}

TEST_F(TangentImport, TurnedTexture) {
    for (const Vertex& vertex : square({0, 0, 0, 1, 1, 0, 1, 1}).vertices) {  // U up, V right
        expect_near(vec3(vertex.tangent), vec3(0, 1, 0));
        EXPECT_EQ(vertex.tangent.w, 1) << "cross(N, T) = -X is the picture's up";
    }
}

TEST_F(TangentImport, TextureWithoutAreaGivesSomeTangent) {
    for (const Vertex& vertex : square({0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f}).vertices) {
        EXPECT_NEAR(glm::dot(vertex.normal, vec3(vertex.tangent)), 0, 1e-6);
    }
}

// Two triangles that share an edge across a mirror line: its vertices are split, each keeps its own side.
TEST_F(TangentImport, SharedVerticesOfAMirroredSeamAreSplit) {
    const Mesh mesh = square({0, 1, 1, 1, 0, 0, 0, 1});  // the second triangle's U runs backwards
    ASSERT_EQ(mesh.indices.size(), 6u);
    EXPECT_EQ(mesh.vertices.size(), 6u);
    for (std::size_t t = 0; t < 2; ++t) {
        for (std::size_t k = 1; k < 3; ++k) {
            EXPECT_EQ(mesh.vertices[mesh.indices[t * 3]].tangent.w,
                      mesh.vertices[mesh.indices[t * 3 + k]].tangent.w);
        }
    }
    EXPECT_NE(mesh.vertices[mesh.indices[0]].tangent.w, mesh.vertices[mesh.indices[3]].tangent.w);
}

// A square of which a corner, or one that nothing uses, is nowhere.
TEST_F(MeshImport, TrianglesWithAPositionThatIsNoNumberAreLeftOut) {
    const int indices = builder.add_scalars<std::uint16_t>({0, 1, 2, 0, 2, 3});
    const float endless = std::numeric_limits<float>::infinity();
    for (const float lost : {std::nanf(""), endless, -endless}) {
        builder.json.erase("meshes");
        builder.json["nodes"] = json::array();
        const int positions = builder.add_vec3({8, 8, 8, 9, 8, 8, 9, 9, 8, 8, lost, 8, lost, lost, lost});
        builder.add_primitive({{"POSITION", positions}}, indices);
        const SceneData scene = import();
        expect_warning(scene, "/accessors/" + std::to_string(positions),
                       "2 positions are not finite; 1 shape that uses them is left out");
        EXPECT_EQ(scene.triangle_count(), 1u);
        EXPECT_EQ(scene.meshes.at(0).bounds.lower, vec3(8));
        EXPECT_EQ(scene.meshes.at(0).bounds.upper, vec3(9, 9, 8));
    }
}

TEST_F(MeshImport, APositionThatIsNoNumberAndThatNothingUsesIsNoMatter) {
    builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, std::nanf(""), 0, 0})}},
                          builder.add_scalars<std::uint16_t>({0, 1, 2}));
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    EXPECT_EQ(scene.meshes.at(0).vertices.size(), 3u);
}

TEST_F(MeshImport, LinesAndPointsThatAreNowhereAreLeftOut) {
    json& primitive = builder.add_primitive(
        {{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, std::nanf(""), 0, 0, 3, 0, 0, 4, 0, 0})}});
    for (const auto& [mode, part] :
         {std::pair(3, "2 shapes that use them are left out"), std::pair(0, "1 shape")}) {
        primitive["mode"] = mode;
        const SceneData scene = import();
        EXPECT_TRUE(std::ranges::any_of(scene.warnings, [&](const std::string& warning) {
            return warning.find(part) != std::string::npos;
        })) << testing::PrintToString(scene.warnings);
        EXPECT_GT(scene.triangle_count(), 0u);
        EXPECT_LE(scene.meshes.at(0).bounds.upper.x, 4.1f);
    }
}

TEST_F(MeshImport, WithoutAnyPositionThePrimitiveIsLeftOut) {
    builder.add_primitive({{"POSITION", builder.add_vec3(std::vector<float>(9, std::nanf("")))}});
    const SceneData scene = import();
    EXPECT_TRUE(scene.meshes.empty());
    EXPECT_EQ(scene.warnings.size(), 2u);
}

TEST_F(MeshImport, TrianglesWithoutAreaAreLeftOut) {
    builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0})}},
                          builder.add_scalars<std::uint8_t>({0, 1, 2, 0, 0, 1, 0, 1, 3}));
    const SceneData scene = import();
    EXPECT_EQ(scene.triangle_count(), 1u);
    expect_warning(scene, "/meshes/0/primitives/0", "2 triangles without area");
}

TEST_F(MeshImport, OnlyTrianglesWithoutArea) {
    builder.add_primitive({{"POSITION", builder.add_vec3({1, 1, 1, 1, 1, 1, 1, 1, 1})}});
    const SceneData scene = import();
    EXPECT_TRUE(scene.meshes.empty());
    EXPECT_EQ(scene.nodes.size(), 1u);
    EXPECT_EQ(scene.warnings.size(), 2u);
}

// Nothing absolute decides what is degenerate: a triangle of 1e-18 m and one of 1e18 m are triangles.
TEST_F(MeshImport, TinyAndHugeTrianglesStay) {
    for (const float size : {1e-18f, 1e18f}) {
        builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, size, 0, 0, 0, size, 0})}});
    }
    const SceneData scene = import();
    ASSERT_EQ(scene.meshes.size(), 2u);
    for (const Mesh& mesh : scene.meshes) {
        EXPECT_EQ(mesh.vertices[0].normal, vec3(0, 0, 1));
    }
}

TEST_F(MeshImport, CountsMustAgree) {
    builder.add_primitive(
        {{"POSITION", builder.add_vec3(kTriangle)}, {"NORMAL", builder.add_vec3({0, 0, 1, 0, 0, 1})}});
    expect_refused("/meshes/0/primitives/0/attributes/NORMAL", "has 2 elements, expected 3");
}

TEST_F(MeshImport, WrongAttributeTypes) {
    builder.add_primitive({{"POSITION", builder.add<float>({0, 0, 1, 0, 0, 1}, "VEC2", 2)}});
    expect_refused("/meshes/0/primitives/0/attributes/POSITION", "is no VEC3");
}

TEST_F(MeshImport, WithoutPositionsIsLeftOut) {
    builder.add_primitive({{"NORMAL", builder.add_vec3(kTriangle)}});
    expect_warning(import(), "/meshes/0/primitives/0/attributes", "no POSITION");
}

TEST_F(MeshImport, OnePrimitiveOneMeshAndTheDefaultMaterialLast) {
    const int positions = builder.add_vec3(kTriangle);
    const int material = builder.add_material({{"name", "red"}});
    json& primitive = builder.add_primitive({{"POSITION", positions}});
    json second = primitive;
    second["material"] = material;
    builder.json["meshes"][0]["name"] = "pair";
    builder.json["meshes"][0]["primitives"].push_back(second);
    builder.json["nodes"].push_back({{"mesh", 0}});
    const SceneData scene = import();
    ASSERT_EQ(scene.meshes.size(), 2u) << "shared by both nodes";
    EXPECT_EQ(scene.meshes[0].name, "pair/0");
    EXPECT_EQ(scene.nodes[1].meshes, (std::vector<std::uint32_t>{0, 1}));
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[0].name, "red");
    EXPECT_EQ(scene.meshes[0].material, 1u);
    EXPECT_EQ(scene.meshes[1].material, 0u);
}

// Nothing that no node shows is read, be it broken.
TEST_F(MeshImport, UnusedMeshesAreNotLoaded) {
    builder.add_triangle();
    builder.json["meshes"].push_back(
        {{"primitives",
          {{{"attributes", {{"POSITION", builder.add_vec3({0, 0, 0, 1, std::nanf(""), 0})}}}}}}});
    EXPECT_EQ(import().meshes.size(), 1u);
}

}  // namespace
}  // namespace lanthorn
