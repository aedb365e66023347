// What exporters write against the specification and other loaders mend: it is mended here too, with a line
// that says what was done. And what a stranger's file may not do.
#include <fmt/format.h>

#include <filesystem>

#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class OddFile : public ImportTest {
  protected:
    void SetUp() override { builder.add_triangle(); }
    SceneData import_text(const std::string& name, const std::string& text) {
        return import_gltf(folder.write(name, text));
    }
};

TEST_F(OddFile, StrideOfZeroIsPacked) {
    builder.json["bufferViews"][0]["byteStride"] = 0;
    const SceneData scene = import();
    expect_warning(scene, "/bufferViews/0/byteStride", "read as tightly packed");
    EXPECT_EQ(scene.triangle_count(), 1u);
}

// Three 16-bit numbers without the padding that glTF asks for.
TEST_F(OddFile, StrideThatIsNoMultipleOfFour) {
    const std::vector<std::uint16_t> positions = {0, 0, 0, 4, 0, 0, 0, 8, 0};
    const int view = builder.add_view(GltfBuilder::bytes_of(positions), 6);
    builder.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
        builder.add_accessor(view, 5123, "VEC3", 3);
    const SceneData scene = import();
    expect_warning(scene, fmt::format("/bufferViews/{}/byteStride", view), "found 6");
    EXPECT_EQ(scene.meshes.at(0).bounds.upper, vec3(4, 8, 0));
}

TEST_F(OddFile, NullIsNothing) {
    builder.add_material({{"normalTexture", nullptr}, {"alphaCutoff", nullptr}});
    builder.json["nodes"][0]["extras"] = {{"keep", nullptr}};
    builder.json["nodes"][0]["camera"] = nullptr;
    builder.json["skins"] = nullptr;
    const SceneData scene = import();
    expect_warning(scene, "JSON", "4 members are null");
    EXPECT_EQ(json::parse(scene.nodes.at(0).extras), json({{"keep", nullptr}}));
}

TEST_F(OddFile, VersionAsANumber) {
    builder.json["asset"]["version"] = 2.0;
    const SceneData scene = import();
    expect_warning(scene, "/asset/version", "found the number 2, expected a string; '2.0' is read");
    EXPECT_EQ(scene.triangle_count(), 1u);
    builder.json["asset"]["version"] = 1.0;
    expect_refused("/asset/version");
}

// Parts of these names are those of the names that are let through.
TEST_F(OddFile, RequiredExtensionsThatNobodyKnowsAreRefused) {
    for (const char* name : {"ACME_node_shapes", "EXT_mesh_features_only", "KHR_texture_of_points", "NOT_VRM",
                             "ACME_GODOT_shapes", "KHR_materials_in_meshes", "EXT_lod"}) {
        builder.json["extensionsRequired"] = {name};
        expect_refused("/extensionsRequired/0", name);
    }
}

// What they add is not drawn; the triangle is.
TEST_F(OddFile, RequiredExtensionsThatShapesDoWithout) {
    for (const char* name : {"KHR_xmp", "MSFT_lod", "GODOT_single_root", "KHR_physics_rigid_bodies",
                             "EXT_structural_metadata", "ADOBE_materials_thin_transparency", "VRM"}) {
        builder.json["extensionsRequired"] = {name};
        const SceneData scene = import();
        expect_warning(scene, "/extensionsUsed", name);
        EXPECT_EQ(scene.triangle_count(), 1u) << name;
    }
}

TEST_F(OddFile, FilesNamedInAnotherCase) {
    fs::create_directory(folder.path() / "Textures");
    folder.write("Textures/Red.PNG", make_png(1, 1, {200, 0, 0}, 3));
    builder.json["images"] = {{{"uri", "textures/red.png"}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["meshes"][0]["primitives"][0]["material"] =
        builder.add_material({{"emissiveTexture", {{"index", 0}}}});
    const SceneData scene = import_text("case.gltf", builder.gltf());
    expect_warning(scene, "/images/0", "is taken for the file 'Textures/Red.PNG'");
    EXPECT_EQ(scene.images.at(0).rgba[0], 200);
    // Two that differ in their case alone: no saying which is meant.
    folder.write("Textures/RED.png", make_png(1, 1, {0, 0, 0}, 3));
    EXPECT_TRUE(import_text("case.gltf", builder.gltf()).images.empty());
}

TEST_F(OddFile, AccessorsWithoutElementsLeaveOutWhatNeedsThem) {
    builder.json["meshes"][0]["primitives"].push_back(
        {{"attributes", {{"POSITION", builder.add_accessor(0, 5126, "VEC3", 0)}}}});
    const SceneData scene = import();
    ASSERT_EQ(scene.warnings.size(), 2u) << testing::PrintToString(scene.warnings);
    EXPECT_NE(scene.warnings[0].find("/accessors/1/count: found 0 elements"), std::string::npos);
    EXPECT_NE(scene.warnings[1].find("/meshes/0/primitives/1: an accessor of it has no data"),
              std::string::npos);
    EXPECT_EQ(scene.triangle_count(), 1u);
}

TEST_F(OddFile, SparseSubstitutionOfNothing) {
    builder.json["accessors"][0]["sparse"] = {{"count", 0}};
    const SceneData scene = import();
    expect_warning(scene, "/accessors/0/sparse", "none is replaced");
    EXPECT_EQ(scene.triangle_count(), 1u);
}

TEST_F(OddFile, AMatrixBesideAScaleCounts) {
    builder.json["nodes"][0]["matrix"] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 5, 0, 0, 1};
    builder.json["nodes"][0]["scale"] = {7, 7, 7};
    const SceneData scene = import();
    expect_warning(scene, "/nodes/0/matrix", "the matrix is used");
    EXPECT_EQ(scene.nodes[0].local.scale, vec3(2));
    EXPECT_EQ(scene.nodes[0].local.translation, dvec3(5, 0, 0));
}

TEST_F(OddFile, NamesInLatin1) {
    builder.json["nodes"][0]["name"] = "NAME";
    std::string text = builder.gltf();
    text.replace(text.find("NAME"), 4, "T\xfcr \xc3\xa4");
    const SceneData scene = import_text("latin.gltf", text);
    expect_warning(scene, "JSON", "1 bytes are no UTF-8; they are read as Latin-1");
    EXPECT_EQ(scene.nodes[0].name, "T\xc3\xbcr \xc3\xa4");
}

TEST_F(OddFile, JsonNamedGlb) {
    const SceneData scene = import_text("scene.glb", " \r\n" + builder.gltf());
    expect_warning(scene, "GLB header", "found JSON");
    EXPECT_EQ(scene.triangle_count(), 1u);
}

TEST_F(OddFile, ManyOfTheSameWordsAreOneLine) {
    for (int i = 0; i < 21; ++i) {
        builder.json["nodes"].push_back({{"rotation", {0, 0, 0, 0}}});
    }
    const SceneData scene = import();
    expect_warning(scene, "/nodes/1/rotation", "(and at 20 more places)");
}

TEST_F(OddFile, ControlCharactersAreWrittenOut) {
    builder.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
    builder.json["meshes"][0]["primitives"][0]["attributes"]["_\x1b[2J\u202e"] = 7;
    try {
        import();
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("_\\x1b[2J\\u202e"), std::string::npos) << error.what();
    }
}

// --- files that a file names ---

class NamedFiles : public OddFile {
  protected:
    void name_buffer(const std::string& uri) {
        builder.json["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
    }
    void name_image(const std::string& uri) {
        builder.json["images"] = {{{"uri", uri}}};
        builder.json["textures"] = {{{"source", 0}}};
        builder.json["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
        builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    }
    SceneData import_from(const std::string& inner, const GltfOptions& options = {}) {
        fs::create_directories(folder.path() / inner);
        return import_gltf(folder.write(inner + "/scene.gltf", builder.gltf()), options);
    }
};

TEST_F(NamedFiles, BackslashesAreSlashes) {
    fs::create_directories(folder.path() / "data");
    folder.write("data/a b.png", make_png(1, 1, {9, 9, 9}, 3));
    name_image("data\\a%20b.png");
    const SceneData scene = import();
    expect_warning(scene, "/images/0", "is taken for the file 'data/a b.png'");
    EXPECT_EQ(scene.images.size(), 1u);
}

TEST_F(NamedFiles, EscapesMayBeMeantAsTheyStand) {
    folder.write("a%20b.bin", builder.buffer);
    name_buffer("a%20b.bin");
    const SceneData scene = import();
    expect_warning(scene, "/buffers/0/uri", "is taken for the file 'a%20b.bin'");
    EXPECT_EQ(scene.triangle_count(), 1u);
}

TEST_F(NamedFiles, NoneIsReadOutsideOfTheFolder) {
    folder.write("secret.bin", builder.buffer);
    folder.write("secret.png", make_png(1, 1, {9, 9, 9}, 3));
    const std::string absolute = (folder.path() / "secret.bin").string();
    for (const std::string& uri :
         {std::string("../secret.bin"), std::string("..%2fsecret.bin"), std::string("..\\secret.bin"),
          absolute, std::string("x/../../secret.bin")}) {
        name_buffer(uri);
        try {
            import_from("inner");
            ADD_FAILURE() << uri;
        } catch (const InputError& error) {
            const std::string line = error.what();
            EXPECT_NE(line.find("/buffers/0/uri: "), std::string::npos) << line;
            EXPECT_NE(line.find("--allow-outside"), std::string::npos) << line;
        }
    }
    name_buffer("../secret.bin");
    EXPECT_EQ(import_from("inner", {"", true}).triangle_count(), 1u);
    builder.json.erase("buffers");
    name_image("../secret.png");
    expect_warning(import_from("inner"), "/images/0", "leads out of the file's folder");
    EXPECT_EQ(import_from("inner", {"", true}).images.size(), 1u);
}

TEST_F(NamedFiles, ALinkLeadsOutToo) {
    folder.write("secret.bin", builder.buffer);
    fs::create_directories(folder.path() / "inner");
    fs::create_symlink("../secret.bin", folder.path() / "inner/link.bin");
    name_buffer("link.bin");
    EXPECT_THROW(import_from("inner"), InputError);
    EXPECT_EQ(import_from("inner", {"", true}).triangle_count(), 1u);
    fs::rename(folder.path() / "secret.bin", folder.path() / "inner/whole.bin");
    fs::remove(folder.path() / "inner/link.bin");
    fs::create_symlink("whole.bin", folder.path() / "inner/link.bin");
    EXPECT_EQ(import_from("inner").triangle_count(), 1u);
}

TEST_F(NamedFiles, AZeroByteHidesNothing) {
    name_buffer("a%00b.bin");
    expect_refused("/buffers/0/uri", "is no file's name");
}

// ISO 3309, as PNG's chunks have it.
std::uint32_t checksum(std::string_view bytes) {
    std::uint32_t sum = 0xffffffffu;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0u);
        }
    }
    return ~sum;
}

// A PNG that states `size`, big-endian, for both sides; its header's checksum is right.
std::string stating(std::string png, const std::string& size) {
    constexpr std::size_t kHeader = 12, kSize = 17;  // "IHDR" and what it holds
    png.replace(16, 8, size + size);
    const std::uint32_t sum = checksum(std::string_view(png).substr(kHeader, kSize));
    for (std::size_t i = 0; i < 4; ++i) {
        png[kHeader + kSize + i] = static_cast<char>(sum >> (24 - 8 * i));
    }
    return png;
}

// deflate cannot hold that much in so little: nothing is made for it.
TEST_F(NamedFiles, AnImageLargerThanItsBytesIsNotBelieved) {
    const std::string png = make_png(1, 1, {9, 9, 9}, 3);
    ASSERT_EQ(stating(png, std::string("\0\0\0\1", 4)), png) << "the checksum is made as PNG's is";
    const std::string large = stating(png, std::string("\0\0\x3f\xff", 4));
    name_image("data:image/png;base64," + base64(large));
    const SceneData scene = import();
    expect_warning(scene, "/images/0",
                   fmt::format("has 16383 x 16383 texels in {} bytes: it is cut off", large.size()));
    EXPECT_EQ(scene.images.size(), 0u);
}

// --- what a scene may cost ---

class Budget : public NamedFiles {};

TEST_F(Budget, PlacementsAreCountedBeforeTheyAreMade) {
    builder.json["meshes"][0]["primitives"].push_back(builder.json["meshes"][0]["primitives"][0]);
    for (int i = 1; i < 6; ++i) {
        builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {i, 0, 0}}});
    }
    ImportBudget budget;
    budget.placements = 7;  // of twelve; three nodes with two each
    const SceneData scene = import_within(budget);
    expect_warning(scene, "/nodes", "6 placements of primitives are left out");
    EXPECT_EQ(scene.nodes[2].meshes.size(), 2u);
    EXPECT_TRUE(scene.nodes[3].meshes.empty());
}

TEST_F(Budget, InstancesCountWithNodes) {
    builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 3, 0}}});
    builder.json["nodes"][1]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
        builder.add_vec3({1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0});
    builder.json["nodes"].push_back(builder.json["nodes"][1]);
    ImportBudget budget;
    budget.placements = 4;
    const SceneData scene = import_within(budget);
    // One of node 0, three instances of node 1; node 2 has none left to show.
    expect_warning(scene, "/nodes", "2 placements of primitives are left out");
    EXPECT_EQ(scene.nodes.size(), 6u);
}

TEST_F(Budget, WeightsOfNodes) {
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}, {{"POSITION", 0}}};
    builder.json["nodes"][0]["weights"] = {0.5, 0.25};
    builder.json["nodes"].push_back(builder.json["nodes"][0]);
    builder.json["nodes"][1]["translation"] = {3, 0, 0};
    ImportBudget budget;
    budget.weights = 3;
    const SceneData scene = import_within(budget);
    expect_warning(scene, "/nodes", "the morph weights of 1 nodes and instances are more");
    EXPECT_EQ(scene.nodes[0].morph_weights, (std::vector<float>{0.5f, 0.25f}));
    EXPECT_TRUE(scene.nodes[1].morph_weights.empty());
}

TEST_F(Budget, PrimitivesThatShareAnAccessor) {
    json& primitives = builder.json["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives.push_back(primitives[0]);
    ImportBudget budget;
    budget.corners = 15;  // six each
    const SceneData scene = import_within(budget);
    expect_warning(scene, "/meshes/0/primitives/2", "its 3 vertices and 3 indices are more than are left");
    EXPECT_EQ(scene.triangle_count(), 2u);
}

TEST_F(Budget, ImagesByWhatTheirHeadersState) {
    const auto png = [](std::uint8_t grey) {
        return "data:image/png;base64," + base64(make_png(2, 2, std::vector<std::uint8_t>(12, grey), 3));
    };
    name_image(png(1));
    builder.json["images"] = {{{"uri", png(1)}}, {{"uri", png(1)}}, {{"uri", png(2)}}, {{"uri", png(3)}}};
    builder.json["textures"] = {{{"source", 0}}, {{"source", 1}}, {{"source", 2}}, {{"source", 3}}};
    builder.json["materials"] = {{{"emissiveTexture", {{"index", 0}}},
                                  {"normalTexture", {{"index", 1}}},
                                  {"occlusionTexture", {{"index", 2}}},
                                  {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 3}}}}}}};
    ImportBudget budget;
    budget.texels = 9;
    const SceneData scene = import_within(budget);
    expect_warning(scene, "/images/2", "the image states 4 texels, more than are left");
    EXPECT_EQ(scene.images.size(), 2u) << "images 0 and 1 are the same";
    ASSERT_TRUE(scene.materials[0].emissive_texture.present());
    EXPECT_EQ(scene.textures[scene.materials[0].emissive_texture.texture].image,
              scene.textures[scene.materials[0].normal_texture.texture].image);
}

TEST_F(OddFile, InstancesInOnePlaceAreCut) {
    for (int i = 1; i < 9000; ++i) {
        builder.json["nodes"].push_back({{"mesh", 0}});
    }
    builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {5, 0, 0}}});
    const SceneData scene = import();
    expect_warning(scene, "nodes", "8000 instances stand where there are 500 layers of surface already");
    EXPECT_EQ(scene.nodes.back().meshes.size(), 1u) << "elsewhere there is room";
}

TEST_F(OddFile, LayersOfOneMeshAreCut) {
    std::vector<float> many;
    for (int i = 0; i < 9000; ++i) {
        many.insert(many.end(), {0, 0, 0, 1, 0, 0, 0, 1, 0});
    }
    builder.add_primitive({{"POSITION", builder.add_vec3(many)}});
    builder.json["nodes"].back()["translation"] = {5, 0, 0};
    const SceneData scene = import();
    expect_warning(scene, "mesh ''", "in more than 500 layers; 8000 of 9000 are left out");
    EXPECT_EQ(scene.triangle_count(), 1001u);
}

TEST_F(OddFile, InstancesAllAroundOnePlaceAreCut) {
    for (int i = 1; i < 40000; ++i) {
        const double x = i % 34 * 0.03, y = i / 34 % 34 * 0.03;
        builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {x, y, 0}}});
    }
    const SceneData scene = import();
    ASSERT_EQ(scene.warnings.size(), 1u) << testing::PrintToString(scene.warnings);
    EXPECT_NE(scene.warnings[0].find("layers of surface on average"), std::string::npos) << scene.warnings[0];
}

}  // namespace
}  // namespace lanthorn
