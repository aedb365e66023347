// A linked GLSL program from files, with uniforms by name.
#pragma once

#include <epoxy/gl.h>

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::gpu {

class Program {
  public:
    Program();
    // Stages by file ending: .vert, .geom, .frag, .comp. Paths relative to the shader root; `defines` as
    // "NAME VALUE". Throws Error with the driver's message, file and line, when a stage does not compile or
    // the program not link. Links nothing where the thread's current Context has had a program of the same
    // text that is held no more: it comes back as after linking.
    explicit Program(const std::vector<std::filesystem::path>& stages,
                     const std::vector<std::string>& defines = {});
    ~Program();
    Program(Program&& other) noexcept;
    Program& operator=(Program&& other) noexcept;

    GLuint id() const;  // GL's name; 0 of a moved-from one
    explicit operator bool() const { return id() != 0; }
    void use() const { glUseProgram(id()); }  // draws and dispatches run it from now on

    // Uniforms of the program, by name; unknown names (optimised away) are ignored by GL.
    void set(const char* name, int value) const;
    void set(const char* name, unsigned value) const;                // of type uint
    void set(const char* name, float value) const;                   // of type float
    void set(const char* name, const vec2& value) const;             // of type vec2
    void set(const char* name, const vec3& value) const;             // of type vec3
    void set(const char* name, const vec4& value) const;             // of type vec4
    void set(const char* name, const ivec2& value) const;            // of type ivec2
    void set(const char* name, std::span<const vec4> values) const;  // a vec4 array from its first element
    void set(const char* name, const mat3& value) const;             // of type mat3
    void set(const char* name, const mat4& value) const;             // of type mat4

    // Dispatches `count` invocations in groups of `group` (per axis, rounded up) after use().
    void dispatch(ivec2 count, ivec2 group) const;
    void dispatch(int count, int group) const { dispatch({count, 1}, {group, 1}); }  // in one dimension

  private:
    struct Held;
    std::unique_ptr<Held> held_;
};

}  // namespace lanthorn::gpu
