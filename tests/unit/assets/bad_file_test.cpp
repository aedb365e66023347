// Files that cannot be read as meant: one line that names file and place.
#include <filesystem>

#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;

class BadFile : public ImportTest {
  protected:
    void expect_text_refused(const std::string& text, const std::string& place,
                             const std::string& part = "") {
        expect_file_refused(folder.write("bad.gltf", text), place, part);
    }
    void expect_glb_refused(const std::string& bytes, const std::string& place,
                            const std::string& part = "") {
        expect_file_refused(folder.write("bad.glb", bytes), place, part);
    }
};

TEST_F(BadFile, Missing) {
    const auto path = folder.path() / "none.glb";
    try {
        import_gltf(path);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()), path.string() + ": found no file '" + path.string() + "'");
    }
}

TEST_F(BadFile, AFolder) {
    EXPECT_THROW(import_gltf(folder.path()), InputError);
}

TEST_F(BadFile, Json) {
    expect_text_refused("", "JSON line 1, column 1", "unexpected end of input");
    expect_text_refused("{\"asset\":", "JSON line 1, column 10", "is not JSON: syntax error");
    expect_text_refused("[]", "/", "found JSON array, expected an object");
    expect_text_refused("7", "/", "expected an object");
    expect_text_refused("{}", "/asset", "found nothing");
    expect_text_refused("{\"asset\":[]}", "/asset", "expected an object");
    expect_text_refused("{\"asset\":{\"version\":3}}", "/asset/version", "expected a string");
    expect_text_refused("{\"asset\":{\"version\":\"\xff\"}}", "/asset/version", "");
    expect_text_refused("{\"asset\":{\"version\":\"1.0\"}}", "/asset/version", "expected 2.x");
    expect_text_refused("{\"asset\":{\"version\":\"2.0\",\"minVersion\":\"2.1\"}}", "/asset/minVersion");
}

// A line that somebody reads, whatever the file quotes.
TEST_F(BadFile, RefusalsAreShort) {
    const std::string rest(300000, 'x');
    for (const std::string& text :
         {"{\"asset\":\"" + rest, "{\"asset\":{\"version\":\"" + rest + "\"}}",
          "{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"" + rest + "\"]}"}) {
        try {
            import_gltf(folder.write("bad.gltf", text));
            ADD_FAILURE() << "loaded";
        } catch (const InputError& error) {
            EXPECT_LE(std::string(error.what()).size(), 500u) << error.what();
        }
    }
}

TEST_F(BadFile, DeepNestingIsRefusedBeforeAnythingRecurses) {
    const std::string deep(1000000, '[');
    expect_text_refused("{\"asset\":{\"version\":\"2.0\"},\"extras\":" + deep, "JSON line 1, column 100",
                        "deeper than 64");
}

TEST_F(BadFile, EveryTruncationOfAGlb) {
    builder.add_triangle();
    const std::string whole = builder.glb();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        try {
            import_gltf(folder.write("cut.glb", whole.substr(0, size)));
            ADD_FAILURE() << "loaded " << size << " of " << whole.size() << " bytes";
        } catch (const InputError& error) {
            expect_places_in(error, folder.path() / "cut.glb");
        }
    }
}

TEST_F(BadFile, GlbContainers) {
    builder.add_triangle();
    const std::string whole = builder.glb();
    expect_glb_refused("PK\x03\x04 and twelve more", "GLB header", "found magic");
    std::string version = whole;
    version[4] = 1;
    expect_glb_refused(version, "GLB header", "container version 1");
    std::string chunk = whole;
    chunk[16] = 'X';
    expect_glb_refused(chunk, "GLB chunk 0", "expected 0x4e4f534a");
    std::string length = whole;
    length[15] = '\x7f';
    expect_glb_refused(length, "GLB chunk 0", "expected 21");
}

TEST_F(BadFile, UnknownRequiredExtensionIsNamed) {
    builder.json["extensionsRequired"] = {"KHR_lights_punctual", "ACME_hexagons"};
    expect_refused("/extensionsRequired/1", "'ACME_hexagons'");
}

TEST_F(BadFile, WrongTypesAnywhere) {
    for (const char* key : {"buffers", "bufferViews", "accessors", "images", "samplers", "textures",
                            "materials", "meshes", "cameras", "nodes", "scenes"}) {
        for (const json& wrong : {json(3), json("x"), json::object(), json(true)}) {
            builder.json = {{"asset", {{"version", "2.0"}}}, {key, wrong}};
            expect_refused(std::string("/") + key, "expected an array of objects");
            builder.json[key] = json::array({wrong.is_object() ? json::array() : wrong});
            expect_refused(std::string("/") + key + "/0", "expected an object");
        }
    }
}

class BadBuffer : public BadFile {
  protected:
    void SetUp() override { builder.add_triangle(); }
};

TEST_F(BadBuffer, MissingFile) {
    builder.json["buffers"] = {{{"byteLength", 36}, {"uri", "none.bin"}}};
    expect_refused("/buffers/0/uri", "found no file");
}

TEST_F(BadBuffer, ShorterThanItSays) {
    folder.write("short.bin", std::string(35, '\0'));
    builder.json["buffers"] = {{{"byteLength", 36}, {"uri", "short.bin"}}};
    expect_refused("/buffers/0/byteLength", "holds 35 bytes, expected 36");
    builder.json["buffers"] = {{{"byteLength", 37}}};
    expect_glb_refused(builder.glb(), "/buffers/0/byteLength", "holds 36 bytes, expected 37");
}

TEST_F(BadBuffer, LongerThanItSaysIsFine) {
    folder.write("long.bin", builder.buffer + "more");
    builder.json["buffers"] = {{{"byteLength", 36}, {"uri", "long.bin"}}};
    EXPECT_EQ(import_gltf(folder.write("scene.gltf", builder.gltf())).triangle_count(), 1u);
}

TEST_F(BadBuffer, ForeignAndBrokenUris) {
    builder.json["buffers"] = {{{"byteLength", 36}, {"uri", "http://example.org/a.bin"}}};
    expect_refused("/buffers/0/uri", "expected a relative path or a data URI");
    builder.json["buffers"] = {{{"byteLength", 36}, {"uri", "data:application/octet-stream;base64,####"}}};
    expect_refused("/buffers/0/uri", "broken data URI");
    builder.json["buffers"] = {{{"byteLength", 36}, {"uri", "data:,plain"}}};
    expect_refused("/buffers/0/uri", "broken data URI");
    builder.json["buffers"] = {{{"byteLength", 36}, {"uri", "a\nb.bin"}}};
    expect_refused("/buffers/0/uri", "found no file");
}

TEST_F(BadBuffer, GlbWithoutItsChunk) {
    builder.json["buffers"] = {{{"byteLength", 36}}};
    builder.buffer.clear();
    const SceneData scene = import_gltf(folder.write("a.glb", builder.glb()));  // as in a .gltf
    expect_warning(scene, "/meshes/0/primitives/0",
                   "an accessor of it has no data; the primitive is left out");
}

TEST_F(BadBuffer, ViewsOutOfTheirBuffer) {
    builder.json["bufferViews"][0]["byteLength"] = 37;
    expect_refused("/bufferViews/0/byteLength", "ends at byte 37, but buffer 0 has 36");
    builder.json["bufferViews"][0]["byteLength"] = 36;
    builder.json["bufferViews"][0]["byteOffset"] = 1;
    expect_refused("/bufferViews/0/byteLength", "ends at byte 37");
    builder.json["bufferViews"][0]["byteOffset"] = -4;
    expect_refused("/bufferViews/0/byteOffset", "found -4");
    builder.json["bufferViews"][0]["byteOffset"] = 0xffffffffffffffffu;
    expect_refused("/bufferViews/0/byteOffset", "found 18446744073709551615");
    builder.json["bufferViews"][0]["byteOffset"] = 0;
    builder.json["bufferViews"][0]["byteStride"] = 8;
    expect_refused("/accessors/0/bufferView", "smaller than an element");
}

TEST_F(BadBuffer, AccessorsOutOfTheirView) {
    builder.json["accessors"][0]["count"] = 4;
    expect_refused("/accessors/0/bufferView", "end at byte 48, but buffer view 0 has 36");
    builder.json["accessors"][0]["count"] = 3;
    builder.json["accessors"][0]["byteOffset"] = 4;
    expect_refused("/accessors/0/bufferView", "end at byte 40");
    builder.json["accessors"][0].erase("byteOffset");
    builder.json["accessors"][0]["bufferView"] = 9;
    expect_refused("/accessors/0/bufferView", "found 9, expected an index below 1");
}

// count * stride must neither overflow nor be believed.
TEST_F(BadBuffer, HugeCounts) {
    for (const json& count : {json(0xffffffffu), json(0x100000000u), json(1.5), json(-1), json(1e300)}) {
        builder.json["accessors"][0]["count"] = count;
        builder.json["accessors"][0]["bufferView"] = 0;
        EXPECT_THROW(import(), InputError) << count;
        builder.json["accessors"][0].erase("bufferView");
        expect_refused("/accessors/0/count");
    }
}

TEST_F(BadBuffer, HugeSparseCounts) {
    builder.json["accessors"][0]["sparse"] = {{"count", 2},
                                              {"indices", {{"bufferView", 0}, {"componentType", 5125}}},
                                              {"values", {{"bufferView", 0}, {"byteOffset", 24}}}};
    expect_refused("/accessors/0/sparse/values/bufferView", "end at byte 48");
    builder.json["accessors"][0]["sparse"]["count"] = 4;
    expect_refused("/accessors/0/sparse/count", "found 4");
}

TEST_F(BadBuffer, UnknownComponentTypes) {
    builder.json["accessors"][0]["componentType"] = 5130;
    expect_refused("/accessors/0/componentType", "expected one of 5120");
    builder.json["accessors"][0]["componentType"] = 5126;
    builder.json["accessors"][0]["type"] = "VEC5";
    expect_refused("/meshes/0/primitives/0/attributes/POSITION", "unknown type 'VEC5'");
}

// JSON pointers escape '~' and '/' (RFC 6901).
TEST_F(BadBuffer, PointersAreEscaped) {
    builder.json["meshes"][0]["primitives"][0]["attributes"]["_A/B~C"] = 7;
    expect_refused("/meshes/0/primitives/0/attributes/_A~1B~0C", "found 7");
}

}  // namespace
}  // namespace lanthorn
