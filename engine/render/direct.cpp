#include "engine/render/direct.h"

#include "engine/render/fullscreen.h"

namespace lanthorn::render {

namespace {
// Texture units.
enum : GLuint { kDistance, kNormals, kAlbedo, kMaterial, kLightMaps, kAreaMaps };
}  // namespace

DirectLight::DirectLight(ivec2 size)
    : size_(size),
      radiance_(gpu::Texture::make_2d(GL_RGBA32F, size)),
      framebuffer_({&radiance_}, nullptr),
      few_({"engine/render/fullscreen.vert", "engine/render/direct.frag"}, {"UNIFORM_LIGHTS"}),
      many_({"engine/render/fullscreen.vert", "engine/render/direct.frag"}) {}

void DirectLight::draw(const GBuffer& gbuffer, const LightMaps& light_maps, const CameraUniforms& camera) {
    const bool few = light_maps.light_count() <= static_cast<int>(kMaxUniformLights);
    const gpu::Program& program = few ? few_ : many_;
    camera.set(program);
    program.set("light_count", light_maps.light_count());
    program.set("gbuffer_distance", static_cast<int>(kDistance));
    program.set("gbuffer_normals", static_cast<int>(kNormals));
    program.set("gbuffer_albedo", static_cast<int>(kAlbedo));
    program.set("gbuffer_material", static_cast<int>(kMaterial));
    program.set("light_map_distance", static_cast<int>(kLightMaps));
    program.set("area_map_distance", static_cast<int>(kAreaMaps));
    gbuffer.distance().bind(kDistance);
    gbuffer.normals().bind(kNormals);
    gbuffer.albedo().bind(kAlbedo);
    gbuffer.material().bind(kMaterial);
    light_maps.distance().bind(kLightMaps);
    light_maps.area_distance().bind(kAreaMaps);
    if (few) {
        light_maps.lights().bind_uniform(kLightsBinding);
    } else {
        light_maps.lights().bind_storage(kLightsBinding);
    }
    draw_fullscreen(program, framebuffer_, size_);
}

}  // namespace lanthorn::render
