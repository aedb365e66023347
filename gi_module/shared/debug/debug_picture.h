// What debug views (gi/technique.h) are drawn with, on the processor: for inspection, not for every frame.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class DebugPicture {
  public:
    explicit DebugPicture(ivec2 size)
        : size_(size), texels_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {}

    ivec2 size() const { return size_; }
    bool has(ivec2 p) const { return p.x >= 0 && p.y >= 0 && p.x < size_.x && p.y < size_.y; }
    // Rows from the bottom, as GL has them.
    vec4& at(ivec2 p) {
        return texels_[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(size_.x) +
                       static_cast<std::size_t>(p.x)];
    }
    // A square of `side` pixels about `middle`, what of it lies in the picture.
    void fill(ivec2 middle, int side, const vec3& colour);
    gpu::Texture texture() const;  // RGBA32F

  private:
    ivec2 size_;
    std::vector<vec4> texels_;
};

// Where the picture shows points of the scene.
class SeenPoints {
  public:
    // Reads the distances of what is seen: waits for the GPU.
    explicit SeenPoints(const render::FrameInputs& inputs);

    // Pixels a side that a point is drawn with.
    int point_side() const { return std::max(1, size_.y / 256); }
    // Draws a point (render space) if nothing hides it; `side`: pixels.
    void draw(DebugPicture& picture, const vec3& position, const vec3& colour, int side) const;
    ivec2 size() const { return size_; }

  private:
    render::CameraUniforms camera_;
    ivec2 size_;
    std::vector<float> distances_;  // rows from the bottom; 0: nothing is seen
};

// A light's colour at its brightest, whatever its amount; black stays black.
vec3 hue_of(const vec3& light);
// A colour for each number, unlike those of the next ones.
vec3 colour_of(std::uint32_t number);

// Six faces of each of some cubes, a row each, from the top: where a face's texel lies in the picture.
struct CubeAtlas {
    int resolution = 0;
    int cubes = 0;

    ivec2 size() const { return {6 * resolution, cubes * resolution}; }
    ivec2 at(int cube, int face, ivec2 texel) const {
        return ivec2(face, cubes - 1 - cube) * resolution + texel;
    }
};

}  // namespace lanthorn::gi
