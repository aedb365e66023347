// Cube maps of planes and albedo, and how the scene is drawn into them: the environment maps proper and the
// candidates' small ones.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/growing_buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/gpu_scene.h"

namespace lanthorn::gi {

// For tracing: planes RG32UI (intersection.glsl says how a plane is kept), albedo RGBA16F (eight bits would
// lose half a percent of the light at each bounce), diffuse, with textures. For coverage: planes RGBA32F, xyz
// = n / dot(n, p), w = distance (negative: back of a single-sided surface; 0: nothing), and no albedo.
// For a caster of caustics, as tracing, but for the albedo: rgb is the smooth normal, outwards.
enum class MapUse { tracing, coverage, caster };

// `slots` cube maps of `resolution`^2 texels a face, layer = 6 * slot + face (engine/render/cube.glsl).
class CubeMaps {
  public:
    CubeMaps() = default;
    CubeMaps(int slots, int resolution, MapUse use);

    int slots() const { return slots_; }
    int resolution() const { return resolution_; }
    const gpu::Texture& planes() const { return planes_; }
    const gpu::Texture& albedo() const { return albedo_; }
    std::size_t bytes() const { return planes_.bytes() + albedo_.bytes() + depth_.bytes(); }

    // Of a map with that centre.
    render::TexelSize texel(const vec3& centre) const {
        return {centre, 2.0f / static_cast<float>(resolution_), 0};
    }

    // To nothing, infinitely far.
    void clear(int layer);
    // What `from`, of the same resolution and use, shows there, or in another of its layers.
    void copy(int layer, const CubeMaps& from) { copy(layer, from, layer); }
    void copy(int layer, const CubeMaps& from, int layer_of_it);
    void bind_for_drawing() const { framebuffer_.bind(ivec2(resolution_)); }

  private:
    int slots_ = 0;
    int resolution_ = 0;
    MapUse use_ = MapUse::tracing;
    gpu::Texture planes_;
    gpu::Texture albedo_;
    gpu::Texture depth_;
    gpu::Framebuffer framebuffer_;
};

// Instances and the layers that each is to be drawn into.
class LayerList {
  public:
    void clear();
    bool empty() const { return runs_.empty(); }
    // Layers of one instance at one level (GpuScene::level) come one after the other, as do those of one
    // material. `centre`: of the layer's map, render space.
    void add(std::uint32_t instance, std::uint32_t level, const vec3& centre, int layer);
    // Some triangles of an instance alone, one by one: those of the last begin_some() until the next one.
    void begin_some(std::uint32_t instance, const vec3& centre, int layer);
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  private:
    friend class MapRenderer;
    std::vector<render::DrawnInstance> runs_;
    std::vector<vec4> layers_;            // centre, layer
    std::vector<std::uint32_t> indices_;  // of some triangles
};

class MapRenderer {
  public:
    explicit MapRenderer(MapUse use);
    // Draws over what `maps` hold. `scene_diagonal` sets the near plane. One draw call an instance and level.
    void draw(const CubeMaps& maps, const render::GpuScene& scene, const LayerList& list,
              float scene_diagonal);

  private:
    gpu::Program program_;
    gpu::GrowingBuffer layers_;
};

}  // namespace lanthorn::gi
