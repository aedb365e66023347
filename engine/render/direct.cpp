#include "engine/render/direct.h"

#include "engine/render/fullscreen.h"

namespace lanthorn::render {

namespace {
// Texture units.
enum : GLuint { kDistance, kNormals, kAlbedo, kMaterial, kLightMaps };
enum : GLuint { kIrradiance = kLightMaps, kBrdfTable };

void bind_surfaces(const gpu::Program& program, const GBuffer& gbuffer, const CameraUniforms& camera) {
    camera.set(program);
    program.set("gbuffer_distance", static_cast<int>(kDistance));
    program.set("gbuffer_normals", static_cast<int>(kNormals));
    program.set("gbuffer_albedo", static_cast<int>(kAlbedo));
    program.set("gbuffer_material", static_cast<int>(kMaterial));
    gbuffer.distance().bind(kDistance);
    gbuffer.normals().bind(kNormals);
    gbuffer.albedo().bind(kAlbedo);
    gbuffer.material().bind(kMaterial);
}

}  // namespace

DirectLight::DirectLight(ivec2 size)
    : size_(size),
      radiance_(gpu::Texture::make_2d(GL_RGBA32F, size)),
      framebuffer_({&radiance_}, nullptr),
      programs_({"engine/render/fullscreen.vert", "engine/render/direct.frag"}),
      compute_programs_({"engine/render/direct.comp"}) {}

void DirectLight::draw(const GBuffer& gbuffer, const LightMaps& light_maps, const CameraUniforms& camera,
                       float traced_roughness, PixelStage stage) {
    const bool compute = in_compute(stage);
    const gpu::Program& program = (compute ? compute_programs_ : programs_).bind(light_maps, kLightMaps);
    bind_surfaces(program, gbuffer, camera);
    program.set("traced_roughness", traced_roughness);
    if (compute) {
        compute_fullscreen(program, radiance_, size_);
    } else {
        draw_fullscreen(program, framebuffer_, size_);
    }
}

void DirectLight::take(const GBuffer& gbuffer, const gpu::Texture& irradiance, const BrdfTable& table,
                       const CameraUniforms& camera) {
    if (!take_program_) {
        take_program_ =
            gpu::Program({"engine/render/fullscreen.vert", "engine/render/reflected_evenly.frag"});
    }
    bind_surfaces(take_program_, gbuffer, camera);
    take_program_.set("irradiance", static_cast<int>(kIrradiance));
    irradiance.bind(kIrradiance);
    table.bind(take_program_, kBrdfTable);
    draw_fullscreen(take_program_, framebuffer_, size_);
}

}  // namespace lanthorn::render
