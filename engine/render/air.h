// Light that thin air scatters once towards the eye, seen as shafts: of point, spot and directional lamps, in
// the shadow of their maps. Asked for at a fraction of the picture's pixels, along each ray at places that
// are as dense as the lamp's light is there (Kulla and Fajardo 2012, "Importance Sampling Techniques for Path
// Tracing in Participating Media", equiangular sampling), within a spot's cone: without shadows and cones a
// lamp's share is exact with a single place.
#pragma once

#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/camera_uniforms.h"
#include "lanthorn/render/gbuffer.h"
#include "lanthorn/render/light_maps.h"
#include "lanthorn/render/light_programs.h"

namespace lanthorn::render {

class AirLight {
  public:
    static constexpr int kTile = 4;  // pixels a side that share a ray

    // For pictures of that size.
    explicit AirLight(ivec2 size);

    struct Medium {
        float scattering = 0;  // 1/m
        int steps = 8;         // places a ray and lamp
        float reach = 0;       // metres that rays go which meet nothing
    };
    // Adds it to the radiance in `target`, but for unlit pixels. O(pixels * steps * lamps / 16).
    void add(const GBuffer& gbuffer, const LightMaps& light_maps, const CameraUniforms& camera,
             const Medium& medium, const gpu::Framebuffer& target);

  private:
    ivec2 size_, tiles_;
    gpu::Texture light_;  // RGBA32F, a texel a tile; a: how far its ray went
    gpu::Framebuffer framebuffer_;
    LightPrograms march_;
    gpu::Program over_;
};

}  // namespace lanthorn::render
