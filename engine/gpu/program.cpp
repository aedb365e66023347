#include "lanthorn/gpu/program.h"

#include <algorithm>
#include <utility>

#include "lanthorn/core/error.h"
#include "lanthorn/gpu/shader_source.h"

namespace lanthorn::gpu {

namespace fs = std::filesystem;

namespace {

GLenum stage_of(const fs::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".vert") return GL_VERTEX_SHADER;
    if (ending == ".geom") return GL_GEOMETRY_SHADER;
    if (ending == ".frag") return GL_FRAGMENT_SHADER;
    if (ending == ".comp") return GL_COMPUTE_SHADER;
    throw Error(ExitCode::bad_input,
                path.string() + ": shader ending expected: .vert, .geom, .frag or .comp");
}

fs::file_time_type newest_of(const std::vector<fs::path>& files) {
    fs::file_time_type newest = fs::file_time_type::min();  // its zero may lie in the future
    for (const fs::path& file : files) {
        std::error_code ignored;
        const auto time = fs::last_write_time(file, ignored);
        if (!ignored) {
            newest = std::max(newest, time);
        }
    }
    return newest;
}

struct Built {
    GLuint program = 0;
    std::vector<fs::path> files;
};

GLuint compile(const fs::path& path, const ShaderSource& source) {
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

Built build(const std::vector<fs::path>& stages, const std::vector<std::string>& defines) {
    Built built;
    std::vector<GLuint> shaders;
    for (const fs::path& path : stages) {
        const ShaderSource source = load_shader(path, defines);
        built.files.insert(built.files.end(), source.files.begin(), source.files.end());
        shaders.push_back(compile(path, source));
    }
    built.program = glCreateProgram();
    for (GLuint shader : shaders) {
        glAttachShader(built.program, shader);
    }
    glLinkProgram(built.program);
    for (GLuint shader : shaders) {
        glDeleteShader(shader);
    }
    GLint ok = 0;
    glGetProgramiv(built.program, GL_LINK_STATUS, &ok);
    if (!ok) {
        std::string log(8192, '\0');
        GLsizei length = 0;
        glGetProgramInfoLog(built.program, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        glDeleteProgram(built.program);
        throw Error(ExitCode::no_gl, stages.front().string() + ": program does not link: " + log);
    }
    return built;
}

}  // namespace

Program::Program(std::vector<fs::path> stages, std::vector<std::string> defines)
    : stages_(std::move(stages)), defines_(std::move(defines)) {
    Built built = build(stages_, defines_);
    id_ = built.program;
    files_ = std::move(built.files);
    newest_ = newest_of(files_);
}

Program::~Program() {
    if (id_ != 0) {
        glDeleteProgram(id_);
    }
}

Program::Program(Program&& other) noexcept
    : stages_(std::move(other.stages_)),
      defines_(std::move(other.defines_)),
      files_(std::move(other.files_)),
      newest_(other.newest_),
      id_(std::exchange(other.id_, 0)),
      locations_(std::move(other.locations_)) {}

Program& Program::operator=(Program&& other) noexcept {
    std::swap(stages_, other.stages_);
    std::swap(defines_, other.defines_);
    std::swap(files_, other.files_);
    std::swap(newest_, other.newest_);
    std::swap(id_, other.id_);
    std::swap(locations_, other.locations_);
    return *this;
}

std::string Program::reload_if_changed() {
    const auto newest = newest_of(files_);
    if (newest == newest_) {
        return {};
    }
    newest_ = newest;
    try {
        Built built = build(stages_, defines_);
        glDeleteProgram(id_);
        id_ = built.program;
        files_ = std::move(built.files);
        locations_.clear();
        return {};
    } catch (const Error& error) {
        return error.what();
    }
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
