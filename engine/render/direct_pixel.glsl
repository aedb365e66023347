// Direct light of every light source at the surface of a pixel.
#include "camera.glsl"
#include "direct.glsl"
#include "gbuffer_flags.glsl"
#include "octahedral.glsl"

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform sampler2D gbuffer_albedo;
uniform sampler2D gbuffer_material;
uniform float traced_roughness;

vec4 pixel_value(ivec2 pixel, vec2 uv) {
    float seen = texelFetch(gbuffer_distance, pixel, 0).r;
    vec4 material = texelFetch(gbuffer_material, pixel, 0);
    if (seen <= 0.0 || flags_say_unlit(material.a)) return vec4(0.0);  // background, unlit
    vec4 normals = texelFetch(gbuffer_normals, pixel, 0);
    vec3 shading = octahedral_decode(normals.xy);
    vec3 geometric = octahedral_decode(normals.zw);
    vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
    vec3 v = -pixel_direction(uv);
    vec3 point = render_position(uv, seen);
    LitSurface surface = LitSurface(point, v, shading, geometric, albedo.rgb, albedo.a, material.r, material.g);
    return vec4(direct_radiance(surface, traced_share(material.r, traced_roughness)), 1.0);
}

#include "pixel_pass.glsl"
