#include "lanthorn/gpu/context.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "engine/gpu/idle_programs.h"
#include "lanthorn/core/error.h"

namespace lanthorn::gpu {

namespace {

void GLAPIENTRY on_debug_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* message,
                                 const void*) {
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) {
        return;
    }
    if (type == GL_DEBUG_TYPE_ERROR) {
        spdlog::error("OpenGL: {}", message);
    } else {
        spdlog::debug("OpenGL: {}", message);
    }
}

bool debug_output_wanted() {
#ifdef NDEBUG
    return std::getenv("LANTHORN_GL_DEBUG") != nullptr;
#else
    return true;
#endif
}

std::string gl_string(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "";
}

}  // namespace

bool draws_in_software() {
    const std::string renderer = gl_string(GL_RENDERER);
    return renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos;
}

bool has_subgroup_sums() {
    constexpr GLint kSums = GL_SUBGROUP_FEATURE_ARITHMETIC_BIT_KHR | GL_SUBGROUP_FEATURE_BALLOT_BIT_KHR;
    if (!epoxy_has_gl_extension("GL_KHR_shader_subgroup")) {
        return false;
    }
    GLint stages = 0, features = 0;
    glGetIntegerv(GL_SUBGROUP_SUPPORTED_STAGES_KHR, &stages);
    glGetIntegerv(GL_SUBGROUP_SUPPORTED_FEATURES_KHR, &features);
    return (stages & GL_COMPUTE_SHADER_BIT) != 0 && (features & kSums) == kSums;
}

Context::Context() : idle_programs_(std::make_shared<IdlePrograms>()) {}

Context::~Context() = default;

void Context::make_current() {
    bind();
    IdlePrograms::set_current(idle_programs_);
}

void Context::adopt_current() {
    if (epoxy_gl_version() < 45) {
        throw Error(ExitCode::no_gl,
                    "OpenGL: found version '" + gl_string(GL_VERSION) + "', expected 4.5 core or later");
    }
    if (!epoxy_has_gl_extension("GL_ARB_shader_viewport_layer_array")) {
        throw Error(ExitCode::no_gl,
                    "OpenGL: '" + gl_string(GL_RENDERER) +
                        "' lacks GL_ARB_shader_viewport_layer_array, which cube maps are drawn with");
    }
    info_ = {gl_string(GL_VENDOR), gl_string(GL_RENDERER), gl_string(GL_VERSION), draws_in_software()};
    if (isatty(STDERR_FILENO) != 0) {  // not into logs and pipes, which reports name it in
        fmt::print(stderr, "OpenGL {} on {}{}\n", info_.version, info_.renderer,
                   info_.software ? ", on the processor" : "");
    }
    if (debug_output_wanted()) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(on_debug_message, nullptr);
    }
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    // Reversed depth with an infinite far plane everywhere: 1 at the near plane, 0 at infinity, cleared to 0.
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDepthFunc(GL_GREATER);
    glClearDepth(0.0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    IdlePrograms::set_current(idle_programs_);
}

}  // namespace lanthorn::gpu
