// From the light at corners to the light at every pixel: the triangles are drawn with it, as the thesis does
// it (Jozwowski 2002, fig. 9, stage 3), where the G-buffer shows them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/gpu/growing_buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class VertexPicture {
  public:
    VertexPicture() = default;
    ~VertexPicture();
    VertexPicture(const VertexPicture&) = delete;
    VertexPicture& operator=(const VertexPicture&) = delete;

    // Positions in render space, 3 corners a triangle. Uploads both.
    void set_triangles(std::span<const vec3> positions, std::span<const std::uint32_t> triangles);

    // By triangle: 1 if any pixel shows it, else 0. Waits for the GPU. O(pixels + triangles).
    std::vector<std::uint32_t> find_seen(const render::FrameInputs& inputs);

    // RGBA32F of the G-buffer's size: irradiance in lux. `light`: by corner, lux. O(pixels + triangles).
    const gpu::Texture& draw(const render::FrameInputs& inputs, std::span<const vec4> light);
    // The same of the light straight from lamps, into a picture of its own.
    const gpu::Texture& draw_lamps(const render::FrameInputs& inputs, std::span<const vec4> light);

  private:
    struct Picture {
        gpu::Texture irradiance;
        gpu::Framebuffer framebuffer;
        void fit(ivec2 size);
    };
    const gpu::Texture& draw_into(Picture& picture, const render::FrameInputs& inputs,
                                  std::span<const vec4> light);
    void draw_triangles(Picture& picture, const render::FrameInputs& inputs, const gpu::Program& program);

    GLuint vertex_array_ = 0;
    gpu::GrowingBuffer positions_, triangles_, light_;
    std::size_t corners_ = 0, indices_ = 0;
    gpu::Program seen_program_, light_program_, fill_program_;
    gpu::Buffer seen_;
    Picture indirect_, lamps_;
};

}  // namespace lanthorn::gi
