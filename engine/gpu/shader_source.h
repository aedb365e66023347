// GLSL files with #include, read from beside the C++ that dispatches them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lanthorn::gpu {

struct ShaderSource {
    std::string text;                          // ready for glShaderSource, with #line directives
    std::vector<std::filesystem::path> files;  // by the source-string number used in #line
};

// The folder that shader paths are relative to: $LANTHORN_SHADERS, else that of the installation
// (core/installation.h), else the source tree that the program was built from.
std::filesystem::path shader_root();

// Reads `path` (relative to the shader root, e.g. "engine/render/gbuffer.frag"), replaces each `#include
// "FILE"` (relative to the including file, else to the root; every file once; none within `#ifdef
// __cplusplus`, so that headers can be shared with C++), puts `defines` ("NAME VALUE" each) and
// `extensions` (GL_..., required) after the #version line. Throws Error naming the missing file and the line
// that includes it.
ShaderSource load_shader(const std::filesystem::path& path, const std::vector<std::string>& defines,
                         const std::vector<std::string>& extensions = {});

// A driver's message with the source-string numbers replaced by file names: "gbuffer.frag:12: ...".
std::string name_files(const std::string& log, const std::vector<std::filesystem::path>& files);

}  // namespace lanthorn::gpu
