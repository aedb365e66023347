// lanthorn convert as a user calls it: what is refused is refused in one line, and nothing is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/support/file_size_limit.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/refused.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn {
namespace {

namespace fs = std::filesystem;
using testing_tools::file_bytes;
using testing_tools::Outcome;
using Words = std::vector<std::string>;

// A triangle whose buffer and image are files of their own.
constexpr const char* kTriangle = R"({
  "asset": {"version": "2.0", "extras": {"who": "Zoë"}},
  "buffers": [{"uri": "parts/tri%20angle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
  "images": [{"uri": "../wood.png"}],
  "textures": [{"source": 0}],
  "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
  "nodes": [{"mesh": 0, "scale": [1.50, 1e0, 1]}]
}
)";

class Convert : public testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(path("in/parts"));
        fs::create_directory(path("out"));
        write("in/a.gltf", kTriangle);
        write("in/parts/tri angle.bin", std::string(36, '\0'));
        write("wood.png", "no picture, but a file");
    }
    std::string path(const std::string& name) const { return folder_.path(name); }
    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
    }
    static Outcome run(const Words& arguments) {
        Words all{"convert"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return testing_tools::run_program(LANTHORN_BINARY, all);
    }
    Outcome run(const std::string& in, const std::string& out) const {
        return run({path(in), path(out), "--allow-outside"});  // the image
    }
    Words all_files() const {
        Words names;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
            names.push_back(entry.path().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }
    // Exit code 2, one line with `part`, and the folder as it was.
    void expect_refused(const std::string& in, const std::string& out, const std::string& part) const {
        const Words before = all_files();
        testing_tools::expect_refusal(run(in, out), part, {in, out});
        EXPECT_EQ(all_files(), before);
    }

    testing_tools::TemporaryFolder folder_;
};

TEST_F(Convert, AnotherFolderGetsWhatTheFileNames) {
    const Outcome result = run("in/a.gltf", "out/b.gltf");
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(file_bytes(path("out/parts/tri angle.bin")), std::string(36, '\0'));
    EXPECT_EQ(file_bytes(path("out/wood.png")), "no picture, but a file") << "not outside of OUT's folder";
    std::string expected = kTriangle;
    expected.replace(expected.find("../wood.png"), 11, "wood.png");
    EXPECT_EQ(file_bytes(path("out/b.gltf")), expected);
    EXPECT_NE(result.out.find("b.gltf  "), std::string::npos) << result.out;
}

// A stranger's file would have a reader of it publish what else lies on the disk.
TEST_F(Convert, WhatIsOutsideOfTheFoldersStaysThere) {
    const Outcome result = run({path("in/a.gltf"), path("out/b.gltf")});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.err.find("'../wood.png' leads out of the file's folder"), std::string::npos)
        << result.err;
    EXPECT_FALSE(fs::exists(path("out/wood.png")));
    EXPECT_EQ(file_bytes(path("out/b.gltf")), kTriangle);
}

// What is read is what was held against the folder: a file named like an escape is no way out of it.
TEST_F(Convert, ADecoyDoesNotLeadOutside) {
    write("secret.bin", std::string(36, 'S'));
    fs::create_directory(path("in/%2e%2e"));
    write("in/%2e%2e/secret.bin", std::string(36, '\0'));
    std::string text = kTriangle;
    text.replace(text.find("parts/tri%20angle.bin"), 21, "%2e%2e/secret.bin");
    write("in/a.gltf", text);
    const Outcome result = run({path("in/a.gltf"), path("out/b.gltf")});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(file_bytes(path("out/secret.bin")), std::string(36, '\0'));
}

// A name with an escape in it, as it stands: import reads it, and so does what is written.
TEST_F(Convert, AFileThatIsNamedLikeAnEscapeIsCopied) {
    fs::rename(path("in/parts/tri angle.bin"), path("in/parts/tri%20angle.bin"));
    const Outcome result = run("in/a.gltf", "out/b.gltf");
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(file_bytes(path("out/parts/tri angle.bin")), std::string(36, '\0'));
}

TEST_F(Convert, InTheSameFolderNothingIsCopied) {
    ASSERT_EQ(run("in/a.gltf", "in/b.gltf").code, 0);
    EXPECT_EQ(file_bytes(path("in/b.gltf")), kTriangle);
    EXPECT_EQ(testing_tools::files_in(path("in")), (Words{"a.gltf", "b.gltf", "parts"}));
}

TEST_F(Convert, ThereAndBack) {
    ASSERT_EQ(run("in/a.gltf", "in/a.glb").code, 0);
    ASSERT_EQ(run("in/a.glb", "in/\xc3\xa4 b.gltf").code, 0);
    EXPECT_EQ(file_bytes(path("in/\xc3\xa4 b.bin")), std::string(36, '\0'));
    EXPECT_NE(file_bytes(path("in/\xc3\xa4 b.gltf"))
                  .find("\"uri\": \"\xc3\xa4%20"
                        "b.bin\""),
              std::string::npos);
    ASSERT_EQ(run("in/\xc3\xa4 b.gltf", "in/c.glb").code, 0);
    EXPECT_EQ(file_bytes(path("in/c.glb")), file_bytes(path("in/a.glb")));
}

// The document alone: in a folder of its own, nothing is beside it, and what is in it is what there was.
TEST_F(Convert, SelfContainedHasTheImagesInIt) {
    const std::string image = "\x89PNG\r\n\x1a\n and the rest";
    write("wood.png", image);
    const Outcome result = run({path("in/a.gltf"), path("out/b.glb"), "--allow-outside", "--self-contained"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(testing_tools::files_in(path("out")), Words{"b.glb"});
    const std::string written = file_bytes(path("out/b.glb"));
    EXPECT_EQ(written.find("wood.png"), std::string::npos);
    for (const char* part :
         {R"("mimeType": "image/png")", R"("name": "wood")", R"("bufferView": 1)", "Zoë"}) {
        EXPECT_NE(written.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(written.find(image), written.find("BIN") + 4 + 36) << "behind the triangle";
    // Written from there, all of it comes along.
    ASSERT_EQ(run("out/b.glb", "out/c.gltf").code, 0);
    EXPECT_EQ(file_bytes(path("out/c.bin")).substr(0, 36 + image.size()), std::string(36, '\0') + image);
}

TEST_F(Convert, SelfContainedTakesInWhatItFinds) {
    const Words arguments{path("in/a.gltf"), path("out/b.glb"), "--self-contained"};
    const Outcome outside = run(arguments);
    ASSERT_EQ(outside.code, 0) << outside.err;
    const std::string said = "'../wood.png' leads out of the file's folder";
    const std::size_t at = outside.err.rfind(said);
    EXPECT_NE(at, std::string::npos) << outside.err;
    EXPECT_NE(file_bytes(path("out/b.glb")).find("../wood.png"), std::string::npos) << "it stays named";
    fs::remove(path("wood.png"));
    const Outcome missing = run({path("in/a.gltf"), path("in/b.glb"), "--allow-outside", "--self-contained"});
    EXPECT_EQ(missing.code, 0);
    EXPECT_NE(missing.err.find("the image stays named"), std::string::npos) << missing.err;
    expect_refused("in/none.gltf", "out/c.glb", "found no file");
    const Words before = all_files();
    const Outcome text = run({path("in/a.gltf"), path("out/c.gltf"), "--self-contained"});
    EXPECT_EQ(text.code, 2);
    EXPECT_NE(text.err.find("c.gltf: found the ending '.gltf', expected .glb with --self-contained"),
              std::string::npos)
        << text.err;
    EXPECT_EQ(all_files(), before);
}

TEST_F(Convert, SelfContainedOfSeveralBuffers) {
    std::string two = kTriangle;
    two.replace(two.find("{\"uri\": \"parts"), 0, "{\"uri\": \"first.bin\", \"byteLength\": 5}, ");
    two.replace(two.find("{\"buffer\": 0"), 12, "{\"buffer\": 1");
    write("in/first.bin", "12345");
    write("in/two.gltf", two);
    for (const std::string name : {"out/b.glb", "out/c.glb"}) {  // a .glb again, too
        const std::string in = name == "out/b.glb" ? path("in/two.gltf") : path("out/b.glb");
        const Outcome result = run({in, path(name), "--allow-outside", "--self-contained"});
        ASSERT_EQ(result.code, 0) << result.err;
        const std::string written = file_bytes(path(name));
        EXPECT_NE(written.find("data:application/octet-stream;base64," + std::string(48, 'A') + '"'),
                  std::string::npos);
        EXPECT_NE(written.find(std::string("12345\0\0\0no picture, but a file", 30)), std::string::npos);
    }
    EXPECT_EQ(testing_tools::files_in(path("out")), (Words{"b.glb", "c.glb"}));
}

TEST_F(Convert, ProjectScenesThereAndBack) {
    for (const char* name : {"cornell", "puppet"}) {
        const std::string scene = support::repository_file("assets/" + std::string(name) + ".glb");
        ASSERT_EQ(run({scene, path("out/a.gltf")}).code, 0);
        ASSERT_EQ(run({path("out/a.gltf"), path("out/b.glb")}).code, 0);
        EXPECT_TRUE(file_bytes(path("out/b.glb")) == file_bytes(scene)) << name;
    }
}

TEST_F(Convert, OntoItselfIsRefusedByAnyName) {
    fs::create_symlink(path("in/a.gltf"), path("out/link.gltf"));
    fs::create_hard_link(path("in/a.gltf"), path("out/hard.gltf"));
    fs::create_directory_symlink(path("in"), path("folder"));
    for (const std::string out :
         {"in/a.gltf", "in/../in/a.gltf", "out/link.gltf", "out/hard.gltf", "folder/a.gltf"}) {
        expect_refused("in/a.gltf", out,
                       path(out) + ": is '" + path("in/a.gltf") + "' itself, expected another file");
    }
    EXPECT_EQ(file_bytes(path("in/a.gltf")), kTriangle);
}

TEST_F(Convert, FilesThatItIsMadeOfAreNotWrittenOver) {
    // Beside OUT, y.bin would replace what the image is.
    std::string both = kTriangle;
    both.replace(both.find("parts/tri%20angle.bin"), 21, "y.bin");
    both.replace(both.find("../wood.png"), 11, "sub/y.bin");
    fs::create_directory(path("in/sub"));
    write("in/y.bin", std::string(36, '\1'));
    write("in/sub/y.bin", std::string(36, '\2'));
    write("in/b.gltf", both);
    expect_refused("in/b.gltf", "in/sub/b.gltf", "in/sub/y.bin: cannot be written: ");
    EXPECT_EQ(file_bytes(path("in/sub/y.bin")), std::string(36, '\2'));
}

TEST_F(Convert, BadInputIsRefusedInOneLine) {
    expect_refused("in/none.gltf", "out/a.gltf", "none.gltf: found no file");
    write("in/broken.gltf", "{\"asset\": ");
    expect_refused("in/broken.gltf", "out/a.gltf", "broken.gltf: JSON line 1, column 11: ");
    write("in/broken.glb", "glTF\2");
    expect_refused("in/broken.glb", "out/a.gltf", "broken.glb: GLB header: ");
    expect_refused("in/a.gltf", "out/none/a.gltf", "none/a.gltf: cannot be written: there is no folder");
    expect_refused("in/a.gltf", "out/a.obj", "out/a.obj: found the ending '.obj', expected .gltf or .glb");
    expect_refused("in/a.gltf", "out/a", "out/a: found the ending '', expected .gltf or .glb");
    expect_refused("in/a.gltf", "out", "out: found the ending '', expected .gltf or .glb");
    fs::create_directory(path("out/folder.glb"));
    expect_refused("in/a.gltf", "out/folder.glb", "exists and is not a regular file");
    fs::remove(path("in/parts/tri angle.bin"));
    for (const std::string out : {"out/a.gltf", "out/a.glb", "in/b.gltf"}) {
        expect_refused("in/a.gltf", out, "in/a.gltf: /buffers/0/uri: found no file ");
    }
}

TEST_F(Convert, AMissingImageStaysNamed) {
    fs::remove(path("wood.png"));
    const Outcome result = run("in/a.gltf", "out/a.gltf");
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.err.find("/images/0/uri: found no file "), std::string::npos) << result.err;
    EXPECT_EQ(file_bytes(path("out/a.gltf")), kTriangle);
}

TEST_F(Convert, ExistingFilesAreReplacedWholeOrNotAtAll) {
    ASSERT_EQ(run("in/a.gltf", "out/a.gltf").code, 0);
    const std::string old_document = file_bytes(path("out/a.gltf"));
    const std::string old_image = file_bytes(path("out/wood.png"));
    write("in/a.gltf", std::string(kTriangle) + "\n");
    ASSERT_GT(old_document.size(), 400u);
    for (const std::size_t image : {10, 500}) {  // the document does not fit; the image does not
        write("wood.png", std::string(image, 'x'));
        const Words before = all_files();
        const Outcome full = [&] {
            const support::FileSizeLimit limit(400);
            return run("in/a.gltf", "out/a.gltf");
        }();
        EXPECT_EQ(full.code, 2);
        EXPECT_EQ(full.error_lines(), 1) << full.err;
        EXPECT_NE(full.err.find(": cannot be written: File too large"), std::string::npos) << full.err;
        EXPECT_EQ(all_files(), before);
        EXPECT_EQ(file_bytes(path("out/a.gltf")), old_document);
        EXPECT_EQ(file_bytes(path("out/wood.png")), old_image);
    }
    EXPECT_EQ(run("in/a.gltf", "out/a.gltf").code, 0);
    EXPECT_NE(file_bytes(path("out/a.gltf")), old_document);
    EXPECT_NE(file_bytes(path("out/wood.png")), old_image);
}

TEST_F(Convert, OtherFilesBesideOutAreNotReplaced) {
    fs::create_directory(path("out/parts"));
    write("out/parts/tri angle.bin", "another's");
    expect_refused("in/a.gltf", "out/a.gltf", "tri angle.bin: cannot be written: another file is there");
    fs::remove(path("out/parts/tri angle.bin"));
    write("out/wood.png", "another's");
    ASSERT_EQ(run("in/a.gltf", "out/a.gltf").code, 0);
    EXPECT_EQ(file_bytes(path("out/wood.png")), "another's");
    EXPECT_EQ(file_bytes(path("out/wood-1.png")), "no picture, but a file");

    write("out/b.bin", "another's");
    ASSERT_EQ(run("in/a.gltf", "in/a.glb").code, 0);
    for (int i = 0; i < 2; ++i) {  // the second time in place of the first
        ASSERT_EQ(run("in/a.glb", "out/b.gltf").code, 0);
        EXPECT_EQ(file_bytes(path("out/b.bin")), "another's");
        EXPECT_EQ(file_bytes(path("out/b-1.bin")), std::string(36, '\0'));
        EXPECT_FALSE(fs::exists(path("out/b-2.bin")));
    }
}

// A file system of 16 kB of its own: no space is left on it, then it is read-only.
TEST_F(Convert, ASmallFileSystem) {
    const std::string script =
        "mount -t tmpfs -o size=16k none \"$1\" || exit 77; cd \"$1\"\n"
        "\"$0\" convert \"$2\" a.gltf; echo $?; ls -A\n"
        "mount -o remount,ro \"$1\" || exit 77\n"
        "\"$0\" convert \"$2\" b.gltf; echo $?; ls -A\n";
    const Outcome result = testing_tools::run_program(
        "/usr/bin/unshare", {"-rm", "sh", "-c", script, LANTHORN_BINARY, path("out"),
                             support::repository_file("assets/puppet.glb")});
    if (result.code != 0) {
        GTEST_SKIP() << "no file system can be mounted here: " << result.err;
    }
    EXPECT_EQ(result.out, "2\n2\n") << "exit codes, and no files";
    EXPECT_EQ(result.err,
              "lanthorn: a.bin: cannot be written: No space left on device\n"
              "lanthorn: b.gltf: cannot be written: Read-only file system\n");
}

TEST_F(Convert, Help) {
    const Outcome result = run({"--help"});
    EXPECT_EQ(result.code, 0);
    for (const char* word : {"IN", "OUT", ".gltf", ".glb", "byte for byte", "NAME.bin"}) {
        EXPECT_NE(result.out.find(word), std::string::npos) << word;
    }
    EXPECT_EQ(run(Words{}).code, 2);
    EXPECT_EQ(run({"a.gltf"}).code, 2);
}

}  // namespace
}  // namespace lanthorn
