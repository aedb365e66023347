#version 450 core
// A see-through surface over what lies behind it: its direct light and emission, weighted with its alpha. The G-buffer has its solid parts.
#include "camera.glsl"
#include "composite_state.glsl"
#include "direct.glsl"
#include "material.glsl"

layout(location = 0) out vec4 out_radiance;

uniform int lit_indirectly;  // 1: as what lies behind; 2: that of the nearest blended surface is known
uniform sampler2D irradiance_behind, irradiance_nearest;  // lux
uniform sampler2D distance_behind, distance_nearest;      // metres; 0: nothing

// Indirect light at a fragment: that of the nearest blended surface, and by distance ever more of what lies behind.
vec3 irradiance_at(float distance) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 behind = texelFetch(irradiance_behind, pixel, 0).rgb;
    if (lit_indirectly < 2) return behind;
    float nearest = texelFetch(distance_nearest, pixel, 0).r, far = texelFetch(distance_behind, pixel, 0).r;
    if (nearest <= 0.0) return behind;
    float share = far > nearest ? clamp((distance - nearest) / (far - nearest), 0.0, 1.0) : 0.0;
    return mix(texelFetch(irradiance_nearest, pixel, 0).rgb, behind, share);
}

void main() {
    vec3 towards = camera_orthographic != 0 ? -camera_forward : camera_position - scene.position;
    vec3 geometric = geometric_normal(towards);
    vec3 shading = shading_normal(gl_FrontFacing);
    SurfaceMaterial m = evaluate_material();
    if (m.alpha >= kSolidAlpha) discard;
    vec3 radiance;
    if (m.unlit) {
        // Shown as it is: undone what the exposure will do.
        radiance = m.base_colour / (state.exposure > 0.0 ? state.exposure : 1.0);
    } else {
        vec3 base = m.base_colour * mix(1.0 - m.transmission, 1.0, m.metallic);
        LitSurface surface = LitSurface(scene.position, normalize(towards), shading, geometric, base, m.metallic, m.roughness, m.f0);
        radiance = m.emissive + direct_radiance(surface, 0.0);
        if (lit_indirectly != 0) {
            float reflects = base_reflectance(m.metallic, m.transmission, m.roughness, materials[scene.material].reflects.y,
                                              materials[scene.material].reflects.z);
            vec3 irradiance = irradiance_at(camera_distance(scene.position - camera_position));
            radiance += irradiance * m.base_colour * (reflects * m.occlusion * 0.31830988618);
        }
    }
    if (is_bad(radiance)) {
        atomicAdd(state.nan_count, 1u);
        radiance = vec3(0.0);
    }
    out_radiance = vec4(radiance, clamp(m.alpha, 0.0, 1.0));
}
