// Compressed data, packed here by the libraries' own encoders.
#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <memory>
#include <utility>

#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;

// A strip of 2 x `columns` vertices along X, one metre wide.
struct Strip {
    explicit Strip(std::uint32_t columns) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            positions.insert(positions.end(), {static_cast<float>(i), 0, 0, static_cast<float>(i), 1, 0});
            if (i > 0) {
                const std::uint32_t a = 2 * i - 2;
                indices.insert(indices.end(), {a, a + 2, a + 1, a + 1, a + 2, a + 3});
            }
        }
    }
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
};

class CompressedImport : public ImportTest {
  protected:
    static constexpr std::uint32_t kColumns = 40;
    const Strip strip{kColumns};

    void expect_strip(const SceneData& scene) {
        EXPECT_TRUE(scene.warnings.empty()) << testing::PrintToString(scene.warnings);
        ASSERT_EQ(scene.meshes.size(), 1u);
        const Mesh& mesh = scene.meshes[0];
        EXPECT_EQ(mesh.indices.size(), strip.indices.size());
        expect_near(mesh.bounds.lower, vec3(0), 1e-3f);
        expect_near(mesh.bounds.upper, vec3(kColumns - 1, 1, 0), 1e-2f);
        double area = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto at = [&](std::size_t c) { return mesh.vertices[mesh.indices[i + c]].position; };
            area += glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2;
        }
        EXPECT_NEAR(area, kColumns - 1, 0.05);
    }
};

// --- EXT_meshopt_compression ---

class Meshopt : public CompressedImport {
  protected:
    void SetUp() override {
        std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(2 * kColumns, 12));
        vertices.resize(meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), strip.positions.data(),
                                                   2 * kColumns, 12));
        std::vector<unsigned char> indices(
            meshopt_encodeIndexBufferBound(strip.indices.size(), 2 * kColumns));
        indices.resize(meshopt_encodeIndexBuffer(indices.data(), indices.size(), strip.indices.data(),
                                                 strip.indices.size()));
        const int v = add_packed(vertices, 2 * kColumns, 12, "ATTRIBUTES");
        const int i = add_packed(indices, strip.indices.size(), 4, "TRIANGLES");
        const int positions = builder.add_accessor(v, 5126, "VEC3", 2 * kColumns);
        builder.add_primitive({{"POSITION", positions}},
                              builder.add_accessor(i, 5125, "SCALAR", strip.indices.size()));
        builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {"EXT_meshopt_compression"};
        builder.json["buffers"] = {
            {{"byteLength", builder.buffer.size()}},
            {{"byteLength", 1 << 20}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
    }
    int add_packed(const std::vector<unsigned char>& bytes, std::size_t count, int stride, const char* mode) {
        const int view = builder.add_view(std::string(bytes.begin(), bytes.end()));
        json& json = builder.json["bufferViews"][static_cast<std::size_t>(view)];
        json["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                         {"byteOffset", json["byteOffset"]},
                                                         {"byteLength", bytes.size()},
                                                         {"byteStride", stride},
                                                         {"count", count},
                                                         {"mode", mode}};
        json["buffer"] = 1;
        json["byteOffset"] = 0;
        json["byteLength"] = count * static_cast<std::size_t>(stride);
        return view;
    }
    SceneData import_glb() { return import_gltf(folder.write("scene.glb", builder.glb())); }
    json& packed(std::size_t view) {
        return builder.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"];
    }
    void expect_glb_refused(const std::string& place, const std::string& part) {
        expect_file_refused(folder.write("bad.glb", builder.glb()), place, part);
    }
};

TEST_F(Meshopt, AttributesAndTriangles) {
    expect_strip(import_glb());
}

TEST_F(Meshopt, Filters) {
    const std::vector<float> values = strip.positions;
    std::vector<std::uint8_t> filtered(values.size() * 4);
    meshopt_encodeFilterExp(filtered.data(), 2 * kColumns, 12, 20, values.data());
    std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(2 * kColumns, 12));
    bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), filtered.data(), 2 * kColumns, 12));
    const int view = add_packed(bytes, 2 * kColumns, 12, "ATTRIBUTES");
    packed(static_cast<std::size_t>(view))["filter"] = "EXPONENTIAL";
    builder.json["accessors"][0]["bufferView"] = view;
    builder.json["buffers"][0]["byteLength"] = builder.buffer.size();
    expect_strip(import_glb());
}

TEST_F(Meshopt, DamageIsRefused) {
    const std::string place = "/bufferViews/0/extensions/EXT_meshopt_compression";
    builder.buffer[0] = 'x';
    expect_glb_refused(place, "damaged");
    packed(0)["count"] = 1000000;
    expect_glb_refused(place + "/count", "but the view has");
    builder.json["bufferViews"][0]["byteLength"] = 12000000;
    builder.json["buffers"][1]["byteLength"] = 12000000;
    expect_glb_refused(place + "/byteLength", "more than any encoder packs");
    packed(0)["byteStride"] = 6;
    expect_glb_refused(place + "/byteStride", "found 6");
    packed(0)["mode"] = "SOMETHING";
    expect_glb_refused(place + "/mode", "expected one of");
}

// Views of the same few bytes may unpack to as much as anybody likes; so it is counted over the file.
TEST_F(Meshopt, WhatAllUnpackToIsCounted) {
    const std::uint64_t whole = 2 * kColumns * 12 + strip.indices.size() * 4;
    ImportBudget budget;
    budget.unpacked = whole;
    builder.json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(builder.buffer);
    const auto import_it = [&] {
        GltfOptions options;
        options.budget = budget;
        return import_gltf(folder.write("scene.gltf", builder.json.dump()), options);
    };
    expect_strip(import_it());
    --budget.unpacked;
    try {
        import_it();
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what())
                      .find("/bufferViews/1/extensions/EXT_meshopt_compression: with this "
                            "the file's data unpacks to more"),
                  std::string::npos)
            << error.what();
    }
}

// --- KHR_draco_mesh_compression ---

class Draco : public CompressedImport {
  protected:
    // With `others` more attributes of 100 numbers each, which no accessor reads.
    void pack(int method, int others = 0) {
        draco::TriangleSoupMeshBuilder soup;
        soup.Start(static_cast<int>(strip.indices.size() / 3));
        const int position = soup.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
        std::vector<int> generic;
        for (int i = 0; i < others; ++i) {
            generic.push_back(soup.AddAttribute(draco::GeometryAttribute::GENERIC, 100, draco::DT_UINT8));
        }
        const std::vector<std::uint8_t> zeros(100);
        for (std::size_t i = 0; i < strip.indices.size(); i += 3) {
            for (const int attribute : generic) {
                soup.SetAttributeValuesForFace(attribute, draco::FaceIndex(static_cast<std::uint32_t>(i / 3)),
                                               zeros.data(), zeros.data(), zeros.data());
            }
            const auto at = [&](std::size_t c) { return &strip.positions[3 * strip.indices[i + c]]; };
            soup.SetAttributeValuesForFace(position, draco::FaceIndex(static_cast<std::uint32_t>(i / 3)),
                                           at(0), at(1), at(2));
        }
        const std::unique_ptr<draco::Mesh> mesh = soup.Finalize();
        draco::ExpertEncoder encoder(*mesh);
        encoder.SetEncodingMethod(method);
        encoder.SetAttributeQuantization(position, 14);
        draco::EncoderBuffer bytes;
        ASSERT_TRUE(encoder.EncodeToBuffer(&bytes).ok());
        const int view = builder.add_view({bytes.data(), bytes.size()});
        const int positions = builder.add_accessor(-1, 5126, "VEC3", mesh->num_points());
        json& primitive = builder.add_primitive(
            {{"POSITION", positions}}, builder.add_accessor(-1, 5123, "SCALAR", strip.indices.size()));
        primitive["extensions"]["KHR_draco_mesh_compression"] = {
            {"bufferView", view}, {"attributes", {{"POSITION", mesh->attribute(position)->unique_id()}}}};
        builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    }
    const std::string place = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";
};

TEST_F(Draco, Edgebreaker) {
    pack(draco::MESH_EDGEBREAKER_ENCODING);
    expect_strip(import());
}

TEST_F(Draco, Sequential) {
    pack(draco::MESH_SEQUENTIAL_ENCODING);
    expect_strip(import());
}

TEST_F(Draco, CountsAreHeldAgainstTheAccessors) {
    pack(draco::MESH_EDGEBREAKER_ENCODING);
    builder.json["accessors"][1]["count"] = 3;
    expect_refused(place, "expected 80 and 1 as the accessors say");
    builder.json["accessors"][1]["count"] = strip.indices.size();
    builder.json["accessors"][0]["count"] = 81;
    expect_refused(place + "/attributes/POSITION", "has 80 vertices, expected 81");
}

// Scans have more corners than an accessor without a view may have otherwise.
TEST_F(Draco, AccessorsMayBeAsLargeAsTheDataSays) {
    pack(draco::MESH_SEQUENTIAL_ENCODING);
    builder.json["accessors"][1]["count"] = 50'000'000;
    expect_strip(import());
    builder.json["accessors"][0]["count"] = 50'000'000;
    expect_refused(place + "/attributes/POSITION", "has 80 vertices, expected 50000000");
    builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["attributes"] = {
        {"NORMAL", 0}};
    expect_refused("/accessors/0/count", "without a buffer view");
}

// A grid of more corners than kMaxZeroElements (4.2 million), as the scan of a statue has.
TEST_F(Draco, AScanOfMillionsOfTriangles) {
    constexpr std::uint32_t kSide = 840;  // vertices
    constexpr std::uint32_t kVertices = kSide * kSide, kTriangles = 2 * (kSide - 1) * (kSide - 1);
    static_assert(3 * kTriangles > 4'194'304);
    draco::Mesh mesh;
    mesh.set_num_points(kVertices);
    auto positions = std::make_unique<draco::PointAttribute>();
    positions->Init(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32, false, kVertices);
    for (std::uint32_t i = 0; i < kVertices; ++i) {
        const vec3 p(static_cast<float>(i % kSide), 0, static_cast<float>(i / kSide));
        positions->SetAttributeValue(draco::AttributeValueIndex(i), &p);
    }
    positions->SetIdentityMapping();
    mesh.AddAttribute(std::move(positions));
    for (std::uint32_t y = 0; y + 1 < kSide; ++y) {
        for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
            const draco::PointIndex a(y * kSide + x), b(a + 1), c(a + kSide), d(c + 1);
            mesh.AddFace({a, c, b});
            mesh.AddFace({b, c, d});
        }
    }
    draco::ExpertEncoder encoder(mesh);
    encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
    encoder.SetSpeedOptions(10, 10);
    draco::EncoderBuffer bytes;
    ASSERT_TRUE(encoder.EncodeToBuffer(&bytes).ok());
    const int view = builder.add_view({bytes.data(), bytes.size()});
    builder.add_primitive({{"POSITION", builder.add_accessor(-1, 5126, "VEC3", kVertices)}},
                          builder.add_accessor(-1, 5125, "SCALAR", 3 * kTriangles));
    builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", {{"POSITION", mesh.attribute(0)->unique_id()}}}};
    const SceneData scene = import_within({});
    EXPECT_EQ(scene.triangle_count(), kTriangles);
    EXPECT_EQ(scene.meshes.at(0).bounds.upper, vec3(kSide - 1, 0, kSide - 1));
    ImportBudget budget;
    budget.unpacked = std::uint64_t{50} << 20;
    try {
        import_within(budget);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("unpacks to more"), std::string::npos) << error.what();
    }
}

TEST_F(Draco, WithoutItsDataThereIsNothing) {
    pack(draco::MESH_SEQUENTIAL_ENCODING);
    for (json& accessor : builder.json["accessors"]) {
        accessor["count"] = 0xffffffffu;
    }
    builder.json["buffers"] = {{{"byteLength", builder.buffer.size()}}};
    const SceneData scene = import_gltf(folder.write("scene.gltf", builder.json.dump()));
    EXPECT_EQ(scene.triangle_count(), 0u);
    expect_warning(scene, "/meshes/0/primitives/0", "no data");
}

TEST_F(Draco, AttributesThatNobodyReadsCount) {
    ImportBudget budget;
    budget.unpacked = 20000;  // 80 vertices and 78 triangles take about 6 kB
    for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING}) {
        builder = GltfBuilder();
        pack(method);
        expect_strip(import_within(budget));
        builder = GltfBuilder();
        pack(method, 3);  // 3 x 100 numbers x 80 vertices
        expect_strip(import_within({}));
        try {
            import_within(budget);
            FAIL();
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(place + ": with this the file's data unpacks to more"),
                      std::string::npos)
                << error.what();
        }
    }
}

TEST_F(Draco, DamageIsRefused) {
    pack(draco::MESH_EDGEBREAKER_ENCODING);
    builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["attributes"]
                ["POSITION"] = 7;
    expect_refused(place + "/attributes/POSITION", "no such attribute 7");
    const std::string whole = builder.buffer;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        builder.buffer = whole;
        builder.buffer[at] = static_cast<char>(builder.buffer[at] ^ 0xff);
        try {
            expect_scene_invariants(import_gltf(folder.write("bad.gltf", builder.gltf())));
        } catch (const InputError&) {
        }
    }
    builder.buffer = whole;
    builder.buffer[0] = 'X';
    expect_refused(place, "damaged head");
}

}  // namespace
}  // namespace lanthorn
