// How much of even light a surface reflects towards the viewer: the integrals of brdf.glsl over all
// directions that light comes from, as a texture.
#pragma once

#include "lanthorn/gpu/texture.h"

namespace lanthorn::render {

// With Schlick's reflectance F = f0 + (f90 - f0) (1 - vh)^5 the specular lobe reflects f0 x + f90 y of even
// light. In 0..1, x + y <= 1. `nv`: cosine between normal and viewer, `roughness`: perceptual, both 0..1. By
// 256 directions (Heitz 2018).
vec2 brdf_share(float nv, float roughness);

class BrdfTable {
  public:
    // Some 10 ms on first use.
    BrdfTable();

    // Sets brdf_table (texture unit `unit`) of a program that includes brdf_table.glsl.
    template <class AnyProgram>
    void bind(const AnyProgram& program, GLuint unit) const {
        texture_.bind(unit);
        program.set("brdf_table", static_cast<int>(unit));
    }

  private:
    gpu::Texture texture_;  // RG32F: nv along x, roughness along y
};

}  // namespace lanthorn::render
