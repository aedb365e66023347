// What exporters write against the specification and other loaders mend: it is mended here too, with a line
// that says what was done. And what a stranger's file may not do.
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

// deflate cannot hold that much in so little: nothing is made for it.
TEST_F(NamedFiles, AnImageLargerThanItsBytesIsNotBelieved) {
    std::string png = make_png(1, 1, {9, 9, 9}, 3);
    png.replace(16, 8, std::string("\x00\x00\x3f\xff\x00\x00\x3f\xff", 8));
    name_image("data:image/png;base64," + base64(png));
    const SceneData scene = import();
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.images.size(), 0u);
}

// --- what a scene may cost ---

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
