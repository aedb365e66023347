// Draws the scene into cube maps of planes and albedo: the environment maps proper and the candidates' small
// ones.
#pragma once

#include <vector>

#include "engine/gpu/buffer.h"
#include "engine/gpu/framebuffer.h"
#include "engine/gpu/program.h"
#include "engine/gpu/texture.h"
#include "engine/render/gpu_scene.h"

namespace lanthorn::gi {

// `slots` cube maps of `resolution`^2 texels a face, layer = 6 * slot + face (engine/render/cube.glsl).
// For tracing: planes RG32UI (intersection.glsl says how a plane is kept), albedo RGBA16F (eight bits would
// lose half a percent of the light at each bounce), diffuse, with textures. For coverage: planes RGBA32F, xyz
// = n / dot(n, p), w = distance (negative: back of a single-sided surface; 0: nothing), and no albedo.
class CubeMaps {
  public:
    enum class Use { tracing, coverage };

    CubeMaps() = default;
    CubeMaps(int slots, int resolution, Use use);

    int slots() const { return slots_; }
    int resolution() const { return resolution_; }
    const gpu::Texture& planes() const { return planes_; }
    const gpu::Texture& albedo() const { return albedo_; }
    std::size_t bytes() const { return planes_.bytes() + albedo_.bytes() + depth_.bytes(); }

    // Draws all six faces of each listed slot anew around centres[slot] (render space). `scene_diagonal` sets
    // the near plane.
    void draw(const render::GpuScene& scene, const std::vector<vec3>& centres, const std::vector<int>& which,
              float scene_diagonal);

  private:
    int slots_ = 0;
    int resolution_ = 0;
    Use use_ = Use::tracing;
    gpu::Texture planes_;
    gpu::Texture albedo_;
    gpu::Texture depth_;
    gpu::Framebuffer framebuffer_;
    gpu::Program program_;
};

}  // namespace lanthorn::gi
