// Documents on their way through files: small ones with everything that a file may have.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "lanthorn/assets/gltf_document.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "tests/support/repository.h"
#include "tests/unit/assets/gltf_builder.h"
#include "tests/unit/assets/round_trip.h"
#include "tests/unit/assets/same_scene.h"

namespace lanthorn {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class DocumentWrite : public testing::Test {
  protected:
    void expect_lossless_both_ways() const {
        expect_lossless(folder_.write("a.gltf", builder_.gltf()), folder_.path() / "from-gltf");
        expect_lossless(folder_.write("a.glb", builder_.glb()), folder_.path() / "from-glb");
    }
    static void expect_refused(const GltfDocument& document, const fs::path& path, const std::string& part) {
        try {
            document.write(path);
            ADD_FAILURE() << "written, expected: " << part;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }

    GltfBuilder builder_;
    TemporaryFolder folder_;
};

TEST_F(DocumentWrite, OneBufferWithAnImage) {
    builder_.add_triangle()["material"] =
        builder_.add_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    builder_.add_texture(make_png(2, 2, std::vector<std::uint8_t>(16, 200), 4));
    expect_lossless_both_ways();
}

TEST_F(DocumentWrite, UnknownMembersUnicodeAndOddNumbers) {
    builder_.add_triangle()["extras"] = {{"z", 1}, {"a", {{"deep", nullptr}}}};
    builder_.json["nodes"][0]["name"] = "\xe7\x81\xaf \"\\\n \xf0\x9f\x8f\xae";
    builder_.json["nodes"][0]["extensions"]["X_unknown"] = {{"list", {1, 2.5, "3"}},
                                                            {"big", 18446744073709551615u}};
    builder_.json["X_member"] = 0.1;
    builder_.json["extensionsUsed"] = {"X_unknown"};
    expect_lossless_both_ways();
    // In the order and spelling of a hand.
    expect_lossless(
        folder_.write("hand.gltf",
                      "\xef\xbb\xbf {\"scene\":0.0,\"nodes\":[{\"scale\":[1.50,1E0,1],\"\\u006eame\":"
                      "\"x\"}],\n\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}]}\n\n"),
        folder_.path() / "hand");
}

TEST_F(DocumentWrite, SeveralBuffersAndSparseAccessors) {
    const int positions = builder_.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int indices = builder_.add_view(GltfBuilder::bytes_of<std::uint16_t>({1}));
    const int values = builder_.add_view(GltfBuilder::bytes_of<float>({2, 0, 0}));
    builder_.json["accessors"][static_cast<std::size_t>(positions)]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
        {"values", {{"bufferView", values}}}};
    builder_.add_primitive({{"POSITION", positions}});
    const std::string second = GltfBuilder::bytes_of<float>({0, 0, 1, 0, 0, 1, 0, 0, 1});
    builder_.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", second.size()}});
    const int normals =
        builder_.add_accessor(static_cast<int>(builder_.json["bufferViews"].size()) - 1, 5126, "VEC3", 3);
    builder_.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
    builder_.json["buffers"] = {{{"byteLength", builder_.buffer.size()},
                                 {"uri", "data:application/gltf-buffer;base64," + base64(builder_.buffer)}},
                                {{"byteLength", second.size()}, {"uri", "second.bin"}, {"name", "2"}}};
    folder_.write("second.bin", second + "behind its byteLength");
    expect_lossless(folder_.write("a.gltf", builder_.gltf()), folder_.path() / "out");
}

TEST_F(DocumentWrite, ProjectScenes) {
    for (const auto& entry : fs::recursive_directory_iterator(support::repository_file("assets"))) {
        if (entry.path().extension() != ".glb") {
            continue;  // levels' pictures, and their folder
        }
        SCOPED_TRACE(entry.path());
        const TemporaryFolder folder;
        expect_lossless(entry.path(), folder.path());
        EXPECT_TRUE(bytes_of(folder.path() / "back" / "a.glb") == bytes_of(entry.path()))
            << "through .gltf and back";
    }
}

TEST_F(DocumentWrite, FilesThatExtensionsNameComeAlong) {
    fs::create_directory(folder_.path() / "ies");
    fs::create_directory(folder_.path() / "out");
    folder_.write("ies/lamp 1.ies", "profile");
    const fs::path file =
        folder_.write("a.gltf", R"({"asset":{"version":"2.0"},"extensionsUsed":["EXT_lights_ies"],
            "extensions":{"EXT_lights_ies":{"lights":[{"uri":"ies/lamp%201.ies"},{"uri":"none.ies"}]}}})");
    const GltfDocument::Written written = GltfDocument::open(file).write(folder_.path() / "out" / "a.gltf");
    EXPECT_EQ(bytes_of(folder_.path() / "out/ies/lamp 1.ies"), "profile");
    EXPECT_EQ(written.files.size(), 2u);
    EXPECT_TRUE(written.warnings.empty());
}

TEST_F(DocumentWrite, UnknownChunksStayInAGlb) {
    builder_.add_triangle();
    std::string glb = builder_.glb();
    glb += std::string("\4\0\0\0OWN!abcd", 12);
    glb[8] = static_cast<char>(glb.size());
    glb[9] = static_cast<char>(glb.size() >> 8);
    const GltfDocument document = GltfDocument::open(folder_.write("a.glb", glb));
    document.write(folder_.path() / "b.glb");
    EXPECT_EQ(bytes_of(folder_.path() / "b.glb"), glb);
    expect_refused(document, folder_.path() / "b.gltf", "a .gltf cannot hold, expected a .glb");
    EXPECT_FALSE(fs::exists(folder_.path() / "b.gltf"));
}

TEST_F(DocumentWrite, AGlbWithoutAnyBuffer) {
    builder_.json["nodes"] = {{{"name", "n"}}};
    expect_lossless_both_ways();
}

// What is added to a file whose buffer is a file of its own goes into another one.
TEST_F(DocumentWrite, AddedMeshesLeaveOtherFilesAlone) {
    builder_.add_triangle();
    builder_.json["buffers"] = {{{"byteLength", builder_.buffer.size()}, {"uri", "b.bin"}}};
    builder_.add_material(nlohmann::json::object());
    folder_.write("b.bin", builder_.buffer);
    Mesh quad;
    quad.name = "quad";
    quad.vertices = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{1, 1, 0}}};
    quad.indices = {0, 1, 2, 2, 1, 3};
    for (const char* in : {"a.gltf", "a.glb"}) {
        GltfDocument document = GltfDocument::open(folder_.write("a.gltf", builder_.gltf()));
        if (std::string(in) == "a.glb") {
            document.write(folder_.path() / in);
            document = GltfDocument::open(folder_.path() / in);
        }
        const auto mesh = static_cast<std::uint32_t>(document.add_mesh({&quad}));
        document.set_node_mesh(document.add_node("added"), mesh);
        document.set_node_mesh(document.add_node("again"), mesh);
        for (const char* out : {"b.gltf", "b.glb"}) {
            SCOPED_TRACE(std::string(in) + " to " + out);
            document.write(folder_.path() / out);
            const SceneData scene = import_gltf(folder_.path() / out);
            ASSERT_EQ(scene.meshes.size(), 2u);
            EXPECT_EQ(scene.meshes[1].name, "quad");
            EXPECT_EQ(scene.meshes[1].indices, quad.indices);
            EXPECT_EQ(scene.meshes[1].vertices[3].position, vec3(1, 1, 0));
            EXPECT_EQ(scene.nodes[2].meshes, scene.nodes[1].meshes);
            EXPECT_EQ(bytes_of(folder_.path() / "b.bin"), builder_.buffer);
            fs::remove(folder_.path() / out);
        }
    }
}

// Under the names that the material's textures ask for, which the importer looks for again.
TEST_F(DocumentWrite, AddedMeshesKeepTheirSetsOfTextureCoordinates) {
    builder_.add_triangle();
    const int texture = builder_.add_texture(make_png(1, 1, {255, 255, 255}, 3));
    const auto info = [&](int set) { return nlohmann::json{{"index", texture}, {"texCoord", set}}; };
    builder_.add_material({{"emissiveTexture", info(3)},
                           {"occlusionTexture", info(2)},
                           {"extensions", {{"KHR_materials_volume", {{"thicknessTexture", info(1)}}}}}});
    GltfDocument document = GltfDocument::open(folder_.write("a.gltf", builder_.gltf()));
    Mesh mesh;
    mesh.vertices = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}};
    mesh.indices = {0, 1, 2};
    for (Vertex& vertex : mesh.vertices) {
        vertex.uv0 = vec2(0.25f);
        vertex.uv1 = vec2(0.75f);
    }
    document.set_node_mesh(document.add_node("added"),
                           static_cast<std::uint32_t>(document.add_mesh({&mesh})));
    document.write(folder_.path() / "b.gltf");
    const SceneData scene = import_gltf(folder_.path() / "b.gltf");
    EXPECT_EQ(scene.materials.at(0).occlusion_texture.uv_set, 0u);
    EXPECT_EQ(scene.materials.at(0).emissive_texture.uv_set, 1u);
    EXPECT_EQ(scene.meshes.at(1).vertices[0].uv0, vec2(0.25f));
    EXPECT_EQ(scene.meshes.at(1).vertices[0].uv1, vec2(0.75f));
}

// What is named like a texture where none is read says nothing of the sets.
TEST_F(DocumentWrite, ExtrasAndUnknownExtensionsAskForNoTextureCoordinates) {
    builder_.add_triangle();
    const nlohmann::json odd = {{"normalTexture", {{"texCoord", "x"}}},
                                {"emissiveTexture", {{"texCoord", 7}}}};
    const int texture = builder_.add_texture(make_png(1, 1, {255, 255, 255}, 3));
    builder_.add_material({{"extras", odd},
                           {"emissiveTexture", {{"index", texture}, {"texCoord", 1}, {"extras", odd}}},
                           {"extensions", {{"ACME_materials_paint", odd}}}});
    const auto info = [&](int set) { return nlohmann::json{{"index", texture}, {"texCoord", set}}; };
    builder_.add_material({{"pbrMetallicRoughness", {{"baseColorTexture", info(5)}}},
                           {"extensions",
                            {{"KHR_materials_specular", {{"specularTexture", info(6)}}},
                             {"KHR_materials_pbrSpecularGlossiness",
                              {{"diffuseTexture", info(3)}, {"specularGlossinessTexture", info(4)}}}}}});
    GltfDocument document = GltfDocument::open(folder_.write("a.gltf", builder_.gltf()));
    Mesh mesh;
    mesh.vertices = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}};
    mesh.indices = {0, 1, 2};
    const auto names_of = [&](std::uint32_t material) {
        mesh.material = material;
        const std::size_t added = document.add_mesh({&mesh});
        const nlohmann::json written = nlohmann::json::parse(document.json_text());
        std::set<std::string> names;
        for (const auto& [name, accessor] : written["meshes"][added]["primitives"][0]["attributes"].items()) {
            names.insert(name);
        }
        return names;
    };
    EXPECT_EQ(names_of(0), (std::set<std::string>{"NORMAL", "POSITION", "TEXCOORD_1"}));
    EXPECT_EQ(names_of(1), (std::set<std::string>{"NORMAL", "POSITION", "TEXCOORD_3", "TEXCOORD_4"}));
}

TEST_F(DocumentWrite, TheDocumentItselfMayBeSaved) {
    builder_.add_triangle();
    const fs::path file = folder_.write("a.glb", builder_.glb());
    GltfDocument document = GltfDocument::open(file);
    document.set_node_name(0, "renamed");
    document.write(file);
    EXPECT_EQ(import_gltf(file).nodes[0].name, "renamed");
}

}  // namespace
}  // namespace lanthorn
