// Subdivision cages from `extras`.
#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;

// Two squares side by side: faces 0 1 4 3 and 1 2 5 4, after a vertex that nothing uses.
const std::vector<float> kVertices = {9, 9, 9, 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0};

class SubdivisionImport : public ImportTest {
  protected:
    json& add_squares() {
        const int indices = builder.add_scalars<std::uint16_t>({1, 2, 5, 1, 5, 4, 2, 3, 6, 2, 6, 5});
        return builder.add_primitive({{"POSITION", builder.add_vec3(kVertices)}}, indices);
    }
    // The cage of the squares' mesh with that `subdivision`; no warnings.
    SubdivisionCage cage_of(const json& subdivision) {
        builder.json["meshes"][0]["primitives"][0]["extras"] = {{"subdivision", subdivision}};
        const SceneData scene = import();
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
        EXPECT_TRUE(scene.meshes.at(0).cage.has_value());
        return scene.meshes[0].cage.value_or(SubdivisionCage{});
    }
    void expect_no_cage(const json& subdivision, const std::string& where, const std::string& part) {
        builder.json["meshes"][0]["primitives"][0]["extras"] = {{"subdivision", subdivision}};
        const SceneData scene = import();
        expect_warning(scene, "/meshes/0/primitives/0/extras/subdivision" + where, part);
        EXPECT_NE(scene.warnings.at(0).find("; not subdivided"), std::string::npos);
        EXPECT_FALSE(scene.meshes.at(0).cage.has_value());
    }
};

TEST_F(SubdivisionImport, QuadsWithACrease) {
    add_squares();
    const SubdivisionCage cage = cage_of({{"scheme", "catmull-clark"},
                                          {"level", 2.0},
                                          {"faces", {4, 4}},
                                          {"creases", {{5, 2, 2.5}, {1, 2, 99}}}});
    EXPECT_EQ(cage.scheme, SubdivisionScheme::catmull_clark);
    EXPECT_EQ(cage.level, 2u);
    EXPECT_EQ(cage.face_sizes, (std::vector<std::uint32_t>{4, 4}));
    // One vertex before them was not used.
    EXPECT_EQ(cage.creases, (std::vector<SubdivisionCrease>{{4, 1, 2.5f}, {0, 1, 10.0f}}));
}

TEST_F(SubdivisionImport, TheVerticesStayTogether) {
    add_squares();
    cage_of({{"scheme", "catmull-clark"}, {"faces", {4, 4}}});
    const SceneData scene = import();
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.vertices.size(), 6u);  // flat normals would have made 12
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4}));
    for (const Vertex& vertex : mesh.vertices) {
        EXPECT_EQ(vertex.normal, vec3(0, 0, 1));
    }
}

TEST_F(SubdivisionImport, LoopOfTrianglesFromTheMeshsExtras) {
    add_squares();
    builder.json["meshes"][0]["extras"] = {{"subdivision", {{"scheme", "loop"}}}};
    const SceneData scene = import();
    ASSERT_TRUE(scene.meshes[0].cage.has_value());
    EXPECT_EQ(scene.meshes[0].cage->scheme, SubdivisionScheme::loop);
    EXPECT_EQ(scene.meshes[0].cage->level, 1u);
    EXPECT_TRUE(scene.meshes[0].cage->face_sizes.empty());
}

TEST_F(SubdivisionImport, ThePrimitivesExtrasGoBeforeTheMeshs) {
    add_squares();
    builder.json["meshes"][0]["extras"] = {{"subdivision", {{"scheme", "loop"}}}};
    EXPECT_EQ(cage_of({{"scheme", "catmull-clark"}, {"level", 3}}).level, 3u);
}

TEST_F(SubdivisionImport, TrianglesWithoutAreaStayInACage) {
    const int indices = builder.add_scalars<std::uint16_t>({0, 1, 2, 0, 2, 1});
    builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, 2, 0, 0})}}, indices);
    cage_of({{"scheme", "loop"}});
    EXPECT_EQ(import().triangle_count(), 2u);
}

TEST_F(SubdivisionImport, OtherExtrasMeanNothing) {
    add_squares()["extras"] = {{"subdivisions", 2}};
    builder.json["meshes"][0]["extras"] = "text";
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_FALSE(scene.meshes[0].cage.has_value());
}

TEST_F(SubdivisionImport, WrongCagesAreToldOfAndLeftOut) {
    add_squares();
    const json good = {{"scheme", "catmull-clark"}, {"level", 2}, {"faces", {4, 4}}};
    const auto with = [&](const char* key, const json& value) {
        json changed = good;
        changed[key] = value;
        return changed;
    };
    expect_no_cage(7, "", "expected an object");
    expect_no_cage(json::object(), "/scheme", "catmull-clark");
    expect_no_cage(with("scheme", "bilinear"), "/scheme", "loop");
    for (const json& level : {json(0), json(6), json(1.5), json("2"), json(-1)}) {
        expect_no_cage(with("level", level), "/level", "from 1 to 5");
    }
    expect_no_cage(with("faces", 4), "/faces", "array");
    expect_no_cage(with("faces", {4, 2}), "/faces/1", "3 or more");
    expect_no_cage(with("faces", {4, 4, 3}), "/faces/2", "more triangles than the primitive's 4");
    expect_no_cage(with("faces", {4}), "/faces", "2 triangles, expected the primitive's 4");
    expect_no_cage(with("faces", {3, 4, 3}), "/faces/1", "not neighbours in a fan");
    expect_no_cage(with("scheme", "loop"), "/faces/0", "expected 3");
    expect_no_cage(with("creases", 1), "/creases", "array");
    expect_no_cage(with("creases", {{1, 2}}), "/creases/0", "sharpness");
    expect_no_cage(with("creases", {{1, 2, -1}}), "/creases/0", "sharpness of 0 or more");
    expect_no_cage(with("creases", {{1, 2, 1}, {1, 5, 1}}), "/creases/1", "edge");  // a diagonal of a square
    expect_no_cage(with("creases", {{1, 999, 1}}), "/creases/0", "edge");
}

TEST_F(SubdivisionImport, StripsAreNoCages) {
    builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})}})["mode"] = 5;
    expect_no_cage({{"scheme", "loop"}}, "", "list of triangles");
}

}  // namespace
}  // namespace lanthorn
