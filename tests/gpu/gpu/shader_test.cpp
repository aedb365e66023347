// Shader files: includes, errors that name the place, reloading, and the objects around them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>

#include "engine/gpu/shader_source.h"
#include "lanthorn/core/error.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"

namespace lanthorn {
namespace {

namespace fs = std::filesystem;

// A folder of shader files that shader paths are relative to while it lives.
class Shaders : public ::testing::Test {
  protected:
    void SetUp() override {
        static const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
        context->make_current();
        root_ = fs::temp_directory_path() / ("lanthorn-shader-test-" + std::to_string(::getpid()));
        fs::remove_all(root_);
        fs::create_directories(root_ / "parts");
        ::setenv("LANTHORN_SHADERS", root_.c_str(), 1);
    }
    void TearDown() override {
        ::unsetenv("LANTHORN_SHADERS");
        fs::remove_all(root_);
    }
    void write(const std::string& name, const std::string& text) {
        std::ofstream(root_ / name) << text;
        // Later than whatever was read before, whatever the clock's grain.
        fs::last_write_time(root_ / name, fs::file_time_type::clock::now() + std::chrono::seconds(++writes_));
    }
    // What a program that writes one float to a buffer at binding 0 writes.
    static float run(const gpu::Program& program) {
        gpu::Buffer result(sizeof(float));
        result.bind_storage(0);
        program.use();
        program.dispatch(1, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        return result.read<float>(1).front();
    }

    fs::path root_;
    int writes_ = 0;
};

const char* const kMain =
    "#version 450 core\n"
    "layout(local_size_x = 1) in;\n"
    "layout(std430, binding = 0) buffer Result { float result; };\n"
    "#include \"parts/value.glsl\"\n"
    "void main() { result = value(); }\n";

TEST_F(Shaders, AnErrorInAnIncludedFileNamesThatFileAndItsLine) {
    write("main.comp", kMain);
    write("parts/value.glsl", "// first line\n\nfloat value() { return undeclared_name; }\n");
    try {
        gpu::Program program({"main.comp"});
        FAIL() << "compiled";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("value.glsl:3"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("undeclared_name"), std::string::npos) << error.what();
    }
}

TEST_F(Shaders, AnErrorAfterAnIncludeNamesTheIncludingFileAndItsLine) {
    write("main.comp", std::string(kMain) + "oops\n");
    write("parts/value.glsl", "float value() { return 1.0; }\n");
    try {
        gpu::Program program({"main.comp"}, {"A 1", "B 2"});
        FAIL() << "compiled";
    } catch (const Error& error) {
        // The parser notices at the end of the file: line 6 or just behind it.
        const std::string what = error.what();
        EXPECT_TRUE(what.find("main.comp:6") != std::string::npos ||
                    what.find("main.comp:7") != std::string::npos)
            << what;
    }
}

TEST_F(Shaders, AMissingIncludeNamesTheFileAndWhoWantsIt) {
    write("main.comp", kMain);
    try {
        gpu::Program program({"main.comp"});
        FAIL() << "compiled";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("value.glsl"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("main.comp:4"), std::string::npos) << error.what();
    }
}

TEST_F(Shaders, AHeaderSharedWithCppKeepsItsCppIncludesToItself) {
    write("main.comp", kMain);
    write("parts/value.glsl",
          "#ifdef __cplusplus\n#include <cstdint>\n#include "
          "\"engine/core/include/lanthorn/core/math.h\"\n#endif\n"
          "float value() { return 3.0; }\n");
    EXPECT_EQ(run(gpu::Program({"main.comp"})), 3.0f);
}

TEST_F(Shaders, DefinesArrive) {
    write("main.comp", kMain);
    write("parts/value.glsl", "float value() { return VALUE; }\n");
    EXPECT_EQ(run(gpu::Program({"main.comp"}, {"VALUE 4.5"})), 4.5f);
}

const char* const kScaled =
    "#version 450 core\n"
    "layout(local_size_x = 1) in;\n"
    "layout(std430, binding = 0) buffer Result { float result; };\n"
    "layout(binding = 3) uniform sampler2D bound;\n"
    "uniform int whole;\nuniform uint count;\nuniform vec4 parts[2];\nuniform mat3 turn;\n"
    "void main() { result = float(whole) + float(count) + parts[0].x + parts[1].y + turn[1][1] + "
    "texelFetch(bound, ivec2(0), 0).x; }\n";

TEST_F(Shaders, WhatIsLinkedIsLentAgainAsAfterLinking) {
    write("main.comp", kScaled);
    std::array<gpu::Texture, 2> textures;
    for (int i = 0; i < 2; ++i) {
        textures[i] = gpu::Texture::make_2d(GL_R32F, {1, 1});
        textures[i].clear(vec4(i == 0 ? 1000.0f : 64.0f));
        glBindTextureUnit(i == 0 ? 3 : 5, textures[i].id());
    }
    GLuint id = 0;
    {
        const gpu::Program first({"main.comp"});
        id = first.id();
        const std::array<vec4, 2> parts{vec4(4), vec4(8)};
        first.set("whole", 1);
        first.set("count", 2u);
        first.set("parts", parts);
        first.set("turn", mat3(16));
        first.set("bound", 5);
        EXPECT_EQ(run(first), 1 + 2 + 4 + 8 + 16 + 64);
        // Two holders at a time have one each.
        const gpu::Program second({"main.comp"});
        EXPECT_NE(second.id(), id);
        EXPECT_EQ(run(second), 1000);
    }
    // They come back, and nothing of what was set.
    const gpu::Program third({"main.comp"}), fourth({"main.comp"});
    EXPECT_TRUE(third.id() == id || fourth.id() == id);
    EXPECT_EQ(run(third), 1000);
    EXPECT_EQ(run(fourth), 1000);
    // Another text is another program, and so is one with other defines.
    EXPECT_NE(gpu::Program({"main.comp"}, {"ANOTHER 1"}).id(), id);
}

TEST_F(Shaders, EachContextHasItsOwnPrograms) {
    write("main.comp", kMain);
    write("parts/value.glsl", "float value() { return 5.0; }\n");
    const auto first = gpu::create_headless_context();
    gpu::Program kept({"main.comp"});
    { const gpu::Program idle({"main.comp"}); }
    {
        const auto second = gpu::create_headless_context();
        EXPECT_EQ(run(gpu::Program({"main.comp"})), 5.0f);
        first->make_current();
        EXPECT_EQ(run(kept), 5.0f);
        EXPECT_EQ(run(gpu::Program({"main.comp"})), 5.0f);
        second->make_current();
        EXPECT_EQ(run(gpu::Program({"main.comp"})), 5.0f);
    }
    first->make_current();
    EXPECT_EQ(run(gpu::Program({"main.comp"})), 5.0f);
}

TEST_F(Shaders, AProgramMayOutliveItsContext) {
    write("main.comp", kMain);
    write("parts/value.glsl", "float value() { return 6.0; }\n");
    auto context = gpu::create_headless_context();
    gpu::Program program({"main.comp"});
    context.reset();
    program = {};
    context = gpu::create_headless_context();
    EXPECT_EQ(run(gpu::Program({"main.comp"})), 6.0f);
}

TEST_F(Shaders, AFramebufferOfOneLayerLeavesTheOthersAlone) {
    gpu::Texture array = gpu::Texture::make_2d_array(GL_R32F, {4, 4}, 3);
    array.clear(vec4(1));
    const gpu::Framebuffer middle({&array}, nullptr, 1);
    const vec4 value(7);
    glClearNamedFramebufferfv(middle.id(), GL_COLOR, 0, &value.x);
    const std::vector<float> texels = array.read_floats(1);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        EXPECT_EQ(texels[i], i / 16 == 1 ? 7.0f : 1.0f) << i;
    }
}

TEST_F(Shaders, AnIncompleteFramebufferIsRefused) {
    const gpu::Texture a = gpu::Texture::make_2d(GL_R32F, {4, 4});
    EXPECT_THROW(gpu::Framebuffer({}, &a), std::logic_error);  // a colour texture as depth
}

TEST_F(Shaders, ABufferGivesBackWhatWasWritten) {
    gpu::Buffer buffer = gpu::Buffer::from(std::vector<int>{1, 2, 3, 4});
    const std::vector<int> two{8, 9};
    buffer.write(4, std::span<const int>(two));
    EXPECT_EQ(buffer.read<int>(4), (std::vector<int>{1, 8, 9, 4}));
    buffer.clear();
    EXPECT_EQ(buffer.read<int>(4), (std::vector<int>{0, 0, 0, 0}));
}

}  // namespace
}  // namespace lanthorn
