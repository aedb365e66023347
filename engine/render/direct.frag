#version 450 core
// Direct light of every light source at the surface of a pixel.
#include "camera.glsl"
#include "direct.glsl"
#include "gbuffer_flags.glsl"
#include "octahedral.glsl"

layout(location = 0) out vec4 out_radiance;

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform sampler2D gbuffer_albedo;
uniform sampler2D gbuffer_material;
uniform float traced_roughness;

in vec2 uv;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float seen = texelFetch(gbuffer_distance, pixel, 0).r;
    vec4 material = texelFetch(gbuffer_material, pixel, 0);
    out_radiance = vec4(0.0);
    if (seen <= 0.0 || flags_say_unlit(material.a)) return;  // background, unlit
    vec4 normals = texelFetch(gbuffer_normals, pixel, 0);
    vec3 shading = octahedral_decode(normals.xy);
    vec3 geometric = octahedral_decode(normals.zw);
    vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
    vec3 v = -pixel_direction(uv);
    vec3 point = render_position(uv, seen);
    LitSurface surface = LitSurface(point, v, shading, geometric, albedo.rgb, albedo.a, material.r, material.g);
    vec3 sum = direct_radiance(surface, traced_share(material.r, traced_roughness));
    out_radiance = vec4(sum, 1.0);
}
