#include "engine/render/air.h"

#include "engine/render/fullscreen.h"

namespace lanthorn::render {

namespace {
enum : GLuint { kAirDistance, kAirMaterial, kAirMaps };  // texture units
enum : GLuint { kAir = kAirMaps };
}  // namespace

AirLight::AirLight(ivec2 size)
    : size_(size),
      tiles_((size + kTile - 1) / kTile),
      light_(gpu::Texture::make_2d(GL_RGBA32F, tiles_)),
      framebuffer_({&light_}, nullptr),
      march_({"engine/render/fullscreen.vert", "engine/render/air.frag"}),
      over_({"engine/render/fullscreen.vert", "engine/render/air_over.frag"}) {}

void AirLight::add(const GBuffer& gbuffer, const LightMaps& light_maps, const CameraUniforms& camera,
                   const Medium& medium, const gpu::Framebuffer& target) {
    gbuffer.distance().bind(kAirDistance);
    gbuffer.material().bind(kAirMaterial);
    const gpu::Program& march = march_.bind(light_maps, kAirMaps);
    camera.set(march);
    march.set("gbuffer_distance", static_cast<int>(kAirDistance));
    march.set("scattering", medium.scattering);
    march.set("steps", medium.steps);
    march.set("reach", medium.reach);
    draw_fullscreen(march, framebuffer_, tiles_);

    over_.set("gbuffer_distance", static_cast<int>(kAirDistance));
    over_.set("gbuffer_material", static_cast<int>(kAirMaterial));
    over_.set("air", static_cast<int>(kAir));
    over_.set("reach", medium.reach);
    light_.bind(kAir);
    target.bind(size_);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
    over_.use();
    bind_no_vertices();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

}  // namespace lanthorn::render
