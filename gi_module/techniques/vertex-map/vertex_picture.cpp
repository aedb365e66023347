#include "gi_module/techniques/vertex-map/vertex_picture.h"

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

VertexPicture::~VertexPicture() {
    if (vertex_array_ != 0) {
        glDeleteVertexArrays(1, &vertex_array_);
    }
}

void VertexPicture::set_triangles(std::span<const vec3> positions, std::span<const std::uint32_t> triangles) {
    corners_ = positions.size();
    indices_ = triangles.size();
    positions_.hold(positions);
    triangles_.hold(triangles);
}

void VertexPicture::Picture::fit(ivec2 size) {
    if (!irradiance || ivec2(irradiance.size()) != size) {
        irradiance = gpu::Texture::make_2d(GL_RGBA32F, size);
        framebuffer = gpu::Framebuffer({&irradiance}, nullptr);
    }
}

void VertexPicture::draw_triangles(Picture& picture, const render::FrameInputs& inputs,
                                   const gpu::Program& program) {
    if (vertex_array_ == 0) {
        glCreateVertexArrays(1, &vertex_array_);
        for (const GLuint attribute : {0u, 1u}) {
            glEnableVertexArrayAttrib(vertex_array_, attribute);
            glVertexArrayAttribFormat(vertex_array_, attribute, attribute == 0 ? 3 : 4, GL_FLOAT, GL_FALSE,
                                      0);
            glVertexArrayAttribBinding(vertex_array_, attribute, attribute);
        }
    }
    glVertexArrayVertexBuffer(vertex_array_, 0, positions_.buffer().id(), 0, sizeof(vec3));
    glVertexArrayVertexBuffer(vertex_array_, 1, light_.buffer().id(), 0, sizeof(vec4));
    glVertexArrayElementBuffer(vertex_array_, triangles_.buffer().id());
    use_surfaces(program, inputs);
    const ivec2 size = inputs.gbuffer.size();
    const float pixel = 2 * glm::length(inputs.camera.up) / static_cast<float>(size.y);
    program.set("pixel_spread", inputs.camera.orthographic ? 0.0f : pixel);
    program.set("pixel_width", inputs.camera.orthographic ? pixel : 0.0f);
    picture.framebuffer.bind(size);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);  // the G-buffer has the depths
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glBindVertexArray(vertex_array_);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices_), GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
    glDisable(GL_CULL_FACE);
}

std::vector<std::uint32_t> VertexPicture::find_seen(const render::FrameInputs& inputs) {
    if (!seen_program_) {
        seen_program_ = gpu::Program({"gi_module/techniques/vertex-map/vertex_light.vert",
                                      "gi_module/techniques/vertex-map/seen_triangles.frag"});
    }
    const std::size_t count = indices_ / 3;
    if (seen_.bytes() < count * sizeof(std::uint32_t) || !seen_) {
        seen_ = gpu::Buffer((count + count / 2) * sizeof(std::uint32_t));
    }
    if (light_.buffer().bytes() < corners_ * sizeof(vec4) || !light_) {
        light_.hold(std::span<const vec4>(std::vector<vec4>(corners_, vec4(0))));
    }
    indirect_.fit(inputs.gbuffer.size());
    seen_.clear();
    seen_.bind_storage(0);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_triangles(indirect_, inputs, seen_program_);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    wait_for_shaders();
    return seen_.read<std::uint32_t>(count);
}

const gpu::Texture& VertexPicture::draw(const render::FrameInputs& inputs, std::span<const vec4> light) {
    return draw_into(indirect_, inputs, light);
}

const gpu::Texture& VertexPicture::draw_lamps(const render::FrameInputs& inputs,
                                              std::span<const vec4> light) {
    return draw_into(lamps_, inputs, light);
}

const gpu::Texture& VertexPicture::draw_into(Picture& picture, const render::FrameInputs& inputs,
                                             std::span<const vec4> light) {
    if (!light_program_) {
        light_program_ = gpu::Program({"gi_module/techniques/vertex-map/vertex_light.vert",
                                       "gi_module/techniques/vertex-map/vertex_light.frag"});
        fill_program_ = gpu::Program({"gi_module/techniques/vertex-map/fill_holes.comp"});
    }
    const ivec2 size = inputs.gbuffer.size();
    picture.fit(size);
    light_.hold(light);
    picture.irradiance.clear(vec4(0));
    draw_triangles(picture, inputs, light_program_);
    use_surfaces(fill_program_, inputs);
    picture.irradiance.bind_image(0, GL_READ_WRITE);
    fill_program_.dispatch(size, ivec2(8));
    wait_for_shaders();
    return picture.irradiance;
}

}  // namespace lanthorn::gi
