#include "gi_module/emc/map_renderer.h"

namespace lanthorn::gi {

CubeMaps::CubeMaps(int slots, int resolution, Use use)
    : slots_(slots),
      resolution_(resolution),
      use_(use),
      planes_(gpu::Texture::make_2d_array(use == Use::tracing ? GL_RG32UI : GL_RGBA32F, ivec2(resolution),
                                          6 * slots)),
      depth_(gpu::Texture::make_2d_array(GL_DEPTH_COMPONENT32F, ivec2(resolution), 6 * slots)) {
    if (use == Use::tracing) {
        albedo_ = gpu::Texture::make_2d_array(GL_RGBA16F, ivec2(resolution), 6 * slots);
        framebuffer_ = gpu::Framebuffer({&planes_, &albedo_}, &depth_);
    } else {
        framebuffer_ = gpu::Framebuffer({&planes_}, &depth_);
    }
    program_ = gpu::Program({"gi_module/emc/environment_map.vert", "gi_module/emc/environment_map.frag"},
                            {use == Use::tracing ? "TRACING 1" : "TRACING 0"});
}

void CubeMaps::draw(const render::GpuScene& scene, const std::vector<vec3>& centres,
                    const std::vector<int>& which, float scene_diagonal) {
    if (which.empty()) {
        return;
    }
    std::vector<vec4> layers;
    layers.reserve(which.size() * 6);
    const vec4 nothing(0.0f);  // zero bits, as floats and as integers
    const bool tracing = use_ == Use::tracing;
    const float far_depth = 0.0f;
    for (int slot : which) {
        for (int face = 0; face < 6; ++face) {
            layers.emplace_back(centres[static_cast<std::size_t>(slot)], static_cast<float>(6 * slot + face));
        }
        glClearTexSubImage(planes_.id(), 0, 0, 0, 6 * slot, resolution_, resolution_, 6,
                           tracing ? GL_RG_INTEGER : GL_RGBA, tracing ? GL_UNSIGNED_INT : GL_FLOAT,
                           &nothing.x);
        glClearTexSubImage(depth_.id(), 0, 0, 0, 6 * slot, resolution_, resolution_, 6, GL_DEPTH_COMPONENT,
                           GL_FLOAT, &far_depth);
    }
    const gpu::Buffer layer_buffer = gpu::Buffer::from(layers);
    framebuffer_.bind(ivec2(resolution_));
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    program_.use();
    program_.set("near_plane", 1e-5f * scene_diagonal);
    layer_buffer.bind_storage(8);
    scene.draw(program_, render::DrawSet::all, static_cast<int>(layers.size()), render::Culling::none);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace lanthorn::gi
