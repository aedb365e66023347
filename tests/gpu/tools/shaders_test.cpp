// Every shader, as the programs compile it, is accepted by the reference compiler for GLSL as well: what one
// driver lets pass, the next may refuse.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <utility>

#include "lanthorn/gpu/context.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"
#include "tools/scene_generator/glb_bytes.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn {
namespace {

namespace fs = std::filesystem;
using testing_tools::Outcome;
using testing_tools::TemporaryFolder;

// Shaders of the source tree, as LANTHORN_SHADER_DUMP names them but for the hash:
// "engine-render-combine.frag".
std::set<std::string> shaders_of_the_tree() {
    std::set<std::string> names;
    const fs::path root = support::repository_file("");
    for (const char* folder : {"engine", "gi_module"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string ending = entry.path().extension().string();
            if (ending == ".comp" || ending == ".frag" || ending == ".vert") {
                std::string name = fs::relative(entry.path(), root).string();
                std::replace(name.begin(), name.end(), '/', '-');
                names.insert(name);
            }
        }
    }
    return names;
}

std::string without_hash(const std::string& file) {
    const std::size_t dash = file.rfind('-'), dot = file.rfind('.');
    return file.substr(0, dash) + file.substr(dot);
}

// Programs that between them compile everything, at a size that costs nothing.
void run_everything(const TemporaryFolder& dump) {
    const std::vector<std::string> environment = {"LANTHORN_SHADER_DUMP=" + dump.path()};
    const TemporaryFolder out;
    const auto render = [&](const std::string& scene, std::vector<std::string> options) {
        std::vector<std::string> arguments = {"render", scene,   "-o",       out.path("x.png"),
                                              "--size", "40x30", "--preset", "low"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome outcome = testing_tools::run_program(LANTHORN_BINARY, arguments, environment);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    };
    const std::string cornell = support::repository_file("assets/cornell.glb");
    const std::string ball = support::repository_file("assets/glass-ball.glb");
    const std::string puppet = support::repository_file("assets/puppet.glb");
    for (const std::string& scene : {puppet, cornell}) {
        render(scene,
               {"--frames", "3", "--set", "render.upscale=temporal", "--set", "render.upscale.scale=0.5"});
    }
    render(ball, {"--frames", "1", "--set", "render.pixel_stage=compute"});
    for (const char* rays : {"maps", "bvh"}) {
        render(puppet, {"--frames", "8", "--set", std::string("gi.emc.rays=") + rays});
        render(ball, {"--frames", "2", "--set", std::string("gi.emc.rays=") + rays});
    }
    render(cornell, {"--frames", "20", "--set", "gi.accumulate=40", "--set", "gi.emc.rays=maps"});
    render(cornell, {"--frames", "3", "--set", "gi.accumulate=3", "--set", "gi.emc.final=splat"});
    render(cornell,
           {"--frames", "2", "--aov", "maps", "--aov", "coverage", "--stats", out.path("stats.json")});
    render(puppet, {"--frames", "3", "--set", "gi.emc.last_round=at_once", "--set", "gi.emc.rays=maps"});
    render(puppet, {"--frames", "8", "--set", "gi.gather.source=rays", "--set", "gi.emc.rays=maps"});
    // Things move here, and no lamp does.
    render(support::repository_file("assets/nave.glb"), {"--frames", "3", "--set", "gi.emc.rays=maps"});
    render(puppet, {"--frames", "3", "--set", "gi.emc.final=splat", "--set", "gi.emc.search=secant"});
    render(support::repository_file("assets/living-room.glb"),
           {"--frames", "1", "--set", "gi.emc.final=splat", "--set", "gi.emc.splat.glossy=variable"});
    render(cornell, {"--technique", "coarse-path", "--frames", "3", "--set", "gi.coarse-path.grid=1"});
    render(puppet, {"--technique", "coarse-path", "--frames", "3"});
    render(ball,
           {"--technique", "drm", "--frames", "1", "--set", "gi.drm.samples=16", "--set", "gi.drm.lights=8"});
    render(cornell, {"--technique", "drm", "--frames", "1"});
    render(ball, {"--technique", "drm", "--frames", "1", "--set", "gi.drm.visibility=maps"});
    render(ball, {"--technique", "vertex-map", "--frames", "2"});
    render(ball, {"--technique", "vertex-map", "--frames", "1", "--set", "gi.vertex-map.direct=true"});
    for (const char* kernel : {"constant", "epanechnikov"}) {
        render(cornell,
               {"--technique", "splat", "--frames", "1", "--set", std::string("gi.splat.kernel=") + kernel});
    }
    render(support::repository_file("assets/lantern-room.glb"), {"--technique", "drm", "--frames", "1"});
    render(support::repository_file("assets/lantern-room.glb"),
           {"--technique", "drm", "--frames", "1", "--set", "gi.drm.visibility=maps"});
    SceneData glass = scene_generator::clutter();
    glass.materials.back().alpha_mode = AlphaMode::blend;
    glass.materials.back().base_colour.a = 0.5f;
    // A clip that paints the walls.
    AnimationClip& clip = glass.animations.emplace_back();
    clip.duration = 1;
    PropertyChannel& paint = clip.properties.emplace_back();
    paint.property = AnimatedProperty::base_colour;
    paint.keys.width = width_of(paint.property);
    paint.keys.times = {0, 1};
    paint.keys.values = {1, 1, 1, 1, 0, 0, 0, 1};
    std::ofstream(out.path("glass.glb"), std::ios::binary) << scene_generator::glb_bytes(glass);
    render(out.path("glass.glb"), {"--frames", "2"});
    for (const auto kind : {scene_generator::LampKind::endless, scene_generator::LampKind::spot}) {
        const std::string lamps = out.path("lamps.glb");
        std::ofstream(lamps, std::ios::binary)
            << scene_generator::glb_bytes(scene_generator::lamp_hall(130, kind));
        render(lamps, {"--frames", "2", "--set", "render.shadow.resolution=16", "--set",
                       "render.air.scattering=0.01"});
    }
    for (const auto& [technique, level] :
         {std::pair("emc", "lantern-room"), {"vertex-map", "levels/red-wall"}}) {
        const Outcome game = testing_tools::run_program(
            LAMPLIGHTER_BINARY,
            {"--headless", "--frames", "2", "--out", out.path(technique), "--size", "64x36", "--level",
             support::repository_file(std::string("assets/") + level + ".glb"), "--set",
             std::string("gi.technique=") + technique},
            environment);
        ASSERT_EQ(game.code, 0) << game.err;
    }
    const Outcome lines =
        testing_tools::run_program(LINES_BINARY, {"--gtest_filter=Lines.AreHidden*"}, environment);
    ASSERT_EQ(lines.code, 0) << lines.out;
}

// Shader storage blocks that OpenGL 4.5 lets a compute shader use at least
// (GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS).
constexpr GLint kPromisedBlocks = 8;

// Storage blocks that a compute shader uses, as the driver finds.
GLint storage_blocks(const std::string& file) {
    std::ifstream in(file);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    const char* source = text.c_str();
    const GLuint program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source);
    GLint linked = 0, blocks = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    EXPECT_EQ(linked, GL_TRUE) << file;
    glGetProgramInterfaceiv(program, GL_SHADER_STORAGE_BLOCK, GL_ACTIVE_RESOURCES, &blocks);
    glDeleteProgram(program);
    return blocks;
}

TEST(Shaders, AreAcceptedByTheReferenceCompiler) {
    const TemporaryFolder dump;
    run_everything(dump);
    std::set<std::string> unseen = shaders_of_the_tree();
    EXPECT_GT(unseen.size(), 40u);
    const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
    std::vector<std::string> paths;
    for (const std::string& file : dump.files()) {
        unseen.erase(without_hash(file));
        paths.push_back(dump.path(file));
        if (file.ends_with(".comp")) {
            EXPECT_LE(storage_blocks(dump.path(file)), kPromisedBlocks) << file;
        }
    }
    const Outcome outcome = testing_tools::run_program(GLSLANG_VALIDATOR, paths);
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    for (const std::string& name : unseen) {
        ADD_FAILURE() << name << " was compiled by none of the programs that this test runs: add one";
    }
}

}  // namespace
}  // namespace lanthorn
