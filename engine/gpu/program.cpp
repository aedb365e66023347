#include "lanthorn/gpu/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <utility>

#include "engine/gpu/shader_source.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"

namespace lanthorn::gpu {

namespace fs = std::filesystem;

namespace {

GLenum stage_of(const fs::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".vert") {
        return GL_VERTEX_SHADER;
    }
    if (ending == ".geom") {
        return GL_GEOMETRY_SHADER;
    }
    if (ending == ".frag") {
        return GL_FRAGMENT_SHADER;
    }
    if (ending == ".comp") {
        return GL_COMPUTE_SHADER;
    }
    throw Error(ExitCode::bad_input,
                path.string() + ": shader ending expected: .vert, .geom, .frag or .comp");
}

// Writes what is compiled, includes and defines in place, to the folder that LANTHORN_SHADER_DUMP names: for
// other compilers to check, and for people to read. One file a text, named after the shader.
void dump(const fs::path& path, const std::string& text) {
    const char* folder = std::getenv("LANTHORN_SHADER_DUMP");
    if (folder == nullptr || *folder == '\0') {
        return;
    }
    std::string name = path.parent_path().string() + '/' + path.stem().string();
    std::ranges::replace(name, '/', '-');
    name += fmt::format("-{:016x}{}", std::hash<std::string>()(text), path.extension().string());
    write_file(fs::path(folder) / name, text);
}

GLuint compile(const fs::path& path, const ShaderSource& source) {
    dump(path, source.text);
    const GLuint shader = glCreateShader(stage_of(path));
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
        std::string log(8192, '\0');
        GLsizei length = 0;
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        glDeleteShader(shader);
        throw Error(ExitCode::no_gl, "shader does not compile:\n" + name_files(log, source.files));
    }
    return shader;
}

GLuint build(const std::vector<fs::path>& stages, const std::vector<std::string>& defines) {
    std::vector<GLuint> shaders;
    shaders.reserve(stages.size());
    for (const fs::path& path : stages) {
        shaders.push_back(compile(path, load_shader(path, defines)));
    }
    const GLuint program = glCreateProgram();
    for (GLuint shader : shaders) {
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    for (GLuint shader : shaders) {
        glDeleteShader(shader);
    }
    GLint ok = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (!ok) {
        std::string log(8192, '\0');
        GLsizei length = 0;
        glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        glDeleteProgram(program);
        throw Error(ExitCode::no_gl, stages.front().string() + ": program does not link: " + log);
    }
    return program;
}

}  // namespace

Program::Program(const std::vector<fs::path>& stages, const std::vector<std::string>& defines)
    : id_(build(stages, defines)) {}

Program::~Program() {
    if (id_ != 0) {
        glDeleteProgram(id_);
    }
}

Program::Program(Program&& other) noexcept
    : id_(std::exchange(other.id_, 0)), locations_(std::move(other.locations_)) {}

Program& Program::operator=(Program&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(locations_, other.locations_);
    return *this;
}

GLint Program::location(const char* name) const {
    auto [entry, inserted] = locations_.try_emplace(name, -1);
    if (inserted) {
        entry->second = glGetUniformLocation(id_, name);
    }
    return entry->second;
}

void Program::set(const char* name, int value) const {
    glProgramUniform1i(id_, location(name), value);
}
void Program::set(const char* name, unsigned value) const {
    glProgramUniform1ui(id_, location(name), value);
}
void Program::set(const char* name, float value) const {
    glProgramUniform1f(id_, location(name), value);
}
void Program::set(const char* name, const vec2& value) const {
    glProgramUniform2fv(id_, location(name), 1, &value.x);
}
void Program::set(const char* name, const vec3& value) const {
    glProgramUniform3fv(id_, location(name), 1, &value.x);
}
void Program::set(const char* name, const vec4& value) const {
    glProgramUniform4fv(id_, location(name), 1, &value.x);
}
void Program::set(const char* name, std::span<const vec4> values) const {
    glProgramUniform4fv(id_, location(name), static_cast<GLsizei>(values.size()), &values.data()->x);
}
void Program::set(const char* name, const ivec2& value) const {
    glProgramUniform2iv(id_, location(name), 1, &value.x);
}
void Program::set(const char* name, const mat3& value) const {
    glProgramUniformMatrix3fv(id_, location(name), 1, GL_FALSE, &value[0].x);
}
void Program::set(const char* name, const mat4& value) const {
    glProgramUniformMatrix4fv(id_, location(name), 1, GL_FALSE, &value[0].x);
}

void Program::dispatch(ivec2 count, ivec2 group) const {
    const ivec2 groups = (count + group - 1) / group;
    if (groups.x > 0 && groups.y > 0) {
        glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
    }
}

}  // namespace lanthorn::gpu
