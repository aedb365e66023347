#include "lanthorn/gpu/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <type_traits>
#include <utility>

#include "engine/gpu/idle_programs.h"
#include "engine/gpu/shader_source.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/gpu/context.h"

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

// What compute shaders count places in lists by, where the driver has it (work_items.glsl).
const std::vector<std::string> kSubgroups = {"GL_KHR_shader_subgroup_basic", "GL_KHR_shader_subgroup_ballot",
                                             "GL_KHR_shader_subgroup_arithmetic"};

std::vector<std::string> with(std::vector<std::string> defines, const char* one) {
    defines.emplace_back(one);
    return defines;
}

GLuint link(const std::vector<fs::path>& stages, const std::vector<ShaderSource>& sources) {
    std::vector<GLuint> shaders;
    shaders.reserve(stages.size());
    for (std::size_t i = 0; i < stages.size(); ++i) {
        shaders.push_back(compile(stages[i], sources[i]));
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

void send(GLuint program, GLint at, const int* values, GLsizei count) {
    glProgramUniform1iv(program, at, count, values);
}
void send(GLuint program, GLint at, const unsigned* values, GLsizei count) {
    glProgramUniform1uiv(program, at, count, values);
}
void send(GLuint program, GLint at, const float* values, GLsizei count) {
    glProgramUniform1fv(program, at, count, values);
}
void send(GLuint program, GLint at, const vec2* values, GLsizei count) {
    glProgramUniform2fv(program, at, count, &values->x);
}
void send(GLuint program, GLint at, const vec3* values, GLsizei count) {
    glProgramUniform3fv(program, at, count, &values->x);
}
void send(GLuint program, GLint at, const vec4* values, GLsizei count) {
    glProgramUniform4fv(program, at, count, &values->x);
}
void send(GLuint program, GLint at, const ivec2* values, GLsizei count) {
    glProgramUniform2iv(program, at, count, &values->x);
}
void send(GLuint program, GLint at, const mat3* values, GLsizei count) {
    glProgramUniformMatrix3fv(program, at, count, GL_FALSE, &(*values)[0].x);
}
void send(GLuint program, GLint at, const mat4* values, GLsizei count) {
    glProgramUniformMatrix4fv(program, at, count, GL_FALSE, &(*values)[0].x);
}

template <typename T>
void put_back(GLuint program, const SetUniform& uniform) {
    const std::vector<T> values(static_cast<std::size_t>(uniform.count), T(uniform.initial));
    send(program, uniform.location, values.data(), uniform.count);
}

}  // namespace

struct Program::Held {
    Held(const std::vector<fs::path>& stages, const std::vector<std::string>& defines) {
        std::vector<ShaderSource> sources;
        std::string all;  // stages by name, too: their ending says what they are
        for (const fs::path& path : stages) {
            const bool by_subgroups = path.extension() == ".comp" && has_subgroup_sums();
            sources.push_back(load_shader(path, by_subgroups ? with(defines, "SUBGROUPS 1") : defines,
                                          by_subgroups ? kSubgroups : std::vector<std::string>()));
            all += path.string() + '\n' + sources.back().text;
        }
        if (const std::shared_ptr<IdlePrograms> store = IdlePrograms::current()) {
            shelf = store->shelf(all);
            linked = IdlePrograms::take(*shelf);
        }
        if (linked.id == 0) {
            linked.id = link(stages, sources);
        }
    }
    ~Held() {
        if (!shelf) {
            glDeleteProgram(linked.id);
        } else if (shelf->open) {
            shelf->idle.push_back(std::move(linked));
        }
    }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;

    template <typename T>
    void set(const char* name, const T* values, GLsizei count = 1) {
        auto [entry, inserted] = linked.uniforms.try_emplace(name);
        SetUniform& uniform = entry->second;
        if (inserted) {
            uniform.location = glGetUniformLocation(linked.id, name);
            uniform.put_back = put_back<T>;
            if (std::is_same_v<T, int> && uniform.location >= 0) {
                glGetUniformiv(linked.id, uniform.location, &uniform.initial);
            }
        }
        uniform.count = std::max(uniform.count, count);
        send(linked.id, uniform.location, values, count);
    }

    LinkedProgram linked;
    std::shared_ptr<IdlePrograms::Shelf> shelf;  // where it lies when nobody holds it; null: nowhere
};

Program::Program() = default;
Program::Program(const std::vector<fs::path>& stages, const std::vector<std::string>& defines)
    : held_(std::make_unique<Held>(stages, defines)) {}
Program::~Program() = default;
Program::Program(Program&& other) noexcept = default;
Program& Program::operator=(Program&& other) noexcept = default;

GLuint Program::id() const {
    return held_ ? held_->linked.id : 0;
}

void Program::set(const char* name, int value) const {
    held_->set(name, &value);
}
void Program::set(const char* name, unsigned value) const {
    held_->set(name, &value);
}
void Program::set(const char* name, float value) const {
    held_->set(name, &value);
}
void Program::set(const char* name, const vec2& value) const {
    held_->set(name, &value);
}
void Program::set(const char* name, const vec3& value) const {
    held_->set(name, &value);
}
void Program::set(const char* name, const vec4& value) const {
    held_->set(name, &value);
}
void Program::set(const char* name, std::span<const vec4> values) const {
    held_->set(name, values.data(), static_cast<GLsizei>(values.size()));
}
void Program::set(const char* name, const ivec2& value) const {
    held_->set(name, &value);
}
void Program::set(const char* name, const mat3& value) const {
    held_->set(name, &value);
}
void Program::set(const char* name, const mat4& value) const {
    held_->set(name, &value);
}

void Program::dispatch(ivec2 count, ivec2 group) const {
    const ivec2 groups = (count + group - 1) / group;
    if (groups.x > 0 && groups.y > 0) {
        glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
    }
}

}  // namespace lanthorn::gpu
