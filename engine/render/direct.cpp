#include "engine/render/direct.h"

#include "engine/render/fullscreen.h"

namespace lanthorn::render {

namespace {
// Texture units.
enum : GLuint { kDistance, kNormals, kAlbedo, kMaterial, kLightMaps };
}  // namespace

DirectLight::DirectLight(ivec2 size)
    : size_(size),
      radiance_(gpu::Texture::make_2d(GL_RGBA32F, size)),
      framebuffer_({&radiance_}, nullptr),
      programs_({"engine/render/fullscreen.vert", "engine/render/direct.frag"}) {}

void DirectLight::draw(const GBuffer& gbuffer, const LightMaps& light_maps, const CameraUniforms& camera,
                       float traced_roughness) {
    const gpu::Program& program = programs_.bind(light_maps, kLightMaps);
    camera.set(program);
    program.set("traced_roughness", traced_roughness);
    program.set("gbuffer_distance", static_cast<int>(kDistance));
    program.set("gbuffer_normals", static_cast<int>(kNormals));
    program.set("gbuffer_albedo", static_cast<int>(kAlbedo));
    program.set("gbuffer_material", static_cast<int>(kMaterial));
    gbuffer.distance().bind(kDistance);
    gbuffer.normals().bind(kNormals);
    gbuffer.albedo().bind(kAlbedo);
    gbuffer.material().bind(kMaterial);
    draw_fullscreen(program, framebuffer_, size_);
}

}  // namespace lanthorn::render
