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
      program_({"engine/render/fullscreen.vert", "engine/render/direct.frag"}) {}

void DirectLight::draw(const GBuffer& gbuffer, const LightMaps& light_maps, const CameraUniforms& camera) {
    camera.set(program_);
    program_.set("light_count", light_maps.light_count());
    program_.set("gbuffer_distance", static_cast<int>(kDistance));
    program_.set("gbuffer_normals", static_cast<int>(kNormals));
    program_.set("gbuffer_albedo", static_cast<int>(kAlbedo));
    program_.set("gbuffer_material", static_cast<int>(kMaterial));
    program_.set("light_map_distance", static_cast<int>(kLightMaps));
    program_.set("area_map_distance", static_cast<int>(kAreaMaps));
    gbuffer.distance().bind(kDistance);
    gbuffer.normals().bind(kNormals);
    gbuffer.albedo().bind(kAlbedo);
    gbuffer.material().bind(kMaterial);
    light_maps.distance().bind(kLightMaps);
    light_maps.area_distance().bind(kAreaMaps);
    light_maps.lights().bind_storage(kLightsBinding);
    draw_fullscreen(program_, framebuffer_, size_);
}

}  // namespace lanthorn::render
