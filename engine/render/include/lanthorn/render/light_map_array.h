// The layers of lights' maps, and beside any of them a still layer: what stands still alone, over which
// movers are drawn again and again.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/texture.h"

namespace lanthorn::render {

class LightMapArray {
  public:
    explicit LightMapArray(bool with_albedo) : with_albedo_(with_albedo) {}

    // Returns whether the layers are new: without content, and none with a still layer. `layers` may be 0.
    bool allocate(int resolution, int layers);

    int resolution() const { return resolution_; }              // texels a side
    const gpu::Texture& distance() const { return distance_; }  // R32F
    const gpu::Texture& normals() const { return normals_; }    // RG16_SNORM
    const gpu::Texture& albedo() const { return albedo_; }      // RGBA16F

    // For drawing, emptied.
    void begin(int layer);

    // Still layers cost what a layer costs and 4 bytes a texel for its depth.
    bool has_still(int layer) const { return stills_[static_cast<std::size_t>(layer)].has_value(); }
    // For drawing into the still layer, which is made where it is missing; cleared, or over what it holds.
    void begin_still(int layer, bool emptied);
    // For drawing into the layer, over a copy of its still one.
    void begin_over_still(int layer);
    // Frees the still layer, if there is one.
    void forget_still(int layer) { stills_[static_cast<std::size_t>(layer)].reset(); }
    void forget_stills();             // of all layers
    std::size_t still_bytes() const;  // GPU memory of all still layers

  private:
    struct Still {
        gpu::Texture distance;
        gpu::Texture normals;
        gpu::Texture albedo;
        gpu::Texture depth;
        gpu::Framebuffer framebuffer;
    };
    void empty(const gpu::Framebuffer& target) const;

    bool with_albedo_;
    int resolution_ = 0;
    gpu::Texture distance_;
    gpu::Texture normals_;
    gpu::Texture albedo_;
    gpu::Texture depth_;                          // one layer, shared
    std::vector<gpu::Framebuffer> framebuffers_;  // by layer
    std::vector<std::optional<Still>> stills_;    // by layer
};

}  // namespace lanthorn::render
