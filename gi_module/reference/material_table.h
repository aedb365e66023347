// Materials as the path tracer evaluates them: engine/render/material.glsl on the CPU.
#pragma once

#include <vector>

#include "lanthorn/scene/diffuse_reflectance.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::reference {

struct TraceInstance;
struct SurfaceHit;

// A material at one point, textures taken in.
struct SurfaceMaterial {
    vec3 base_colour{1};
    float alpha = 1;
    vec3 emissive{0};  // nits
    float metallic = 0;
    float roughness = 1;  // perceptual
    float f0 = 0.04f;     // dielectric reflectance at normal incidence
    float occlusion = 1;
    float transmission = 0;

    // What is left of it where light meets no boundary of a volume: the same without its transmitting share.
    SurfaceMaterial opaque_part() const;
    // What of the light is scattered diffusely, once, Fresnel apart.
    vec3 diffuse_albedo() const { return base_colour * ((1 - metallic) * (1 - transmission)); }
};

// What of a material does not change over a surface.
struct MaterialConstants {
    bool plain = true;  // no texture changes its reflectance
    bool mask = false;
    bool blend = false;
    bool double_sided = false;
    bool unlit = false;
    bool emits = false;         // gives_light()
    bool emits_evenly = false;  // the same everywhere: emitted
    bool transmits = false;     // some of the light, smoothly or roughly
    bool sees_through = false;  // part of a ray may go straight on: blended, or smooth and transmitting
    bool volume = false;        // bounds one that light enters: bent, and absorbed on its way
    float ior = 1.5f;           // of the volume
    vec3 absorption{0};         // of the volume, 1/m
    MaterialReflectance reflects;
    vec3 reflectance{0};     // of a plain material with white vertex colours
    vec3 emitted{0};         // nits, by factors alone (emissive_pieces.h)
    bool untextured = true;  // the same everywhere, where vertex colours are white: surface
    SurfaceMaterial surface;
};

class MaterialTable {
  public:
    explicit MaterialTable(const SceneAssets& assets);  // `assets` must outlive this

    const MaterialConstants& operator[](std::uint32_t material) const { return constants_[material]; }

    // All of the following at weights `barycentric` of the second and third vertex of a triangle.
    // What of even light is reflected (diffuse_reflectance.h): the albedo of diffuse transport.
    vec3 reflectance(const TraceInstance& instance, std::uint32_t primitive, const vec2& barycentric) const;
    SurfaceMaterial evaluate(const TraceInstance& instance, std::uint32_t primitive,
                             const vec2& barycentric) const;
    // Emitted radiance in nits, of a front or a double-sided back; alpha taken in.
    vec3 emission(const TraceInstance& instance, std::uint32_t primitive, const vec2& barycentric) const;
    // Whether a masked material leaves the point out.
    bool cut_out(const TraceInstance& instance, std::uint32_t primitive, const vec2& barycentric) const;
    // Of a blended material, 0..1.
    float alpha(const TraceInstance& instance, std::uint32_t primitive, const vec2& barycentric) const;
    // The shading normal with normal mapping, unit, turned to the side that the ray came from.
    vec3 shading_normal(const TraceInstance& instance, const SurfaceHit& hit) const;

  private:
    const SceneAssets& assets_;
    std::vector<MaterialConstants> constants_;  // by slot of the assets' materials
};

}  // namespace lanthorn::reference
