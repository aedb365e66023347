// A program that draws the scene, in a variant for each kind of material.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "engine/gpu/program.h"

namespace lanthorn::render {

// What a material asks of a shader. A software rasteriser samples every texture that a shader names, and a
// shader that may discard tests depth late: so materials get no more than they need.
enum class MaterialKind { plain, textured, masked };

class SceneProgram {
  public:
    // `fragment` includes material.glsl; it is built with UNTEXTURED, with nothing, and with MASKED (where
    // alone it needs to discard).
    SceneProgram(const std::filesystem::path& vertex, const std::filesystem::path& fragment);

    const gpu::Program& variant(MaterialKind kind) const { return variants_[static_cast<std::size_t>(kind)]; }

    // Sets a uniform of all variants.
    template <class T>
    void set(const char* name, const T& value) const {
        for (const gpu::Program& program : variants_) {
            program.set(name, value);
        }
    }
    std::string reload_if_changed();

  private:
    std::array<gpu::Program, 3> variants_;
};

}  // namespace lanthorn::render
