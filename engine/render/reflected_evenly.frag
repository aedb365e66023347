#version 450 core
// What the surface of a pixel reflects of light whose irradiance is known and whose directions are not: as if it came evenly.
#include "camera.glsl"
#include "brdf_table.glsl"
#include "gbuffer_flags.glsl"
#include "octahedral.glsl"

layout(location = 0) out vec4 out_radiance;  // nits

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform sampler2D gbuffer_albedo;
uniform sampler2D gbuffer_material;
uniform sampler2D irradiance;  // lux

in vec2 uv;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 material = texelFetch(gbuffer_material, pixel, 0);
    out_radiance = vec4(0.0);
    if (texelFetch(gbuffer_distance, pixel, 0).r <= 0.0 || flags_say_unlit(material.a)) return;  // background, unlit
    vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
    vec3 normal = octahedral_decode(texelFetch(gbuffer_normals, pixel, 0).xy);
    float nv = dot(normal, -pixel_direction(uv));
    Reflectance reflects = reflectance(albedo.rgb, albedo.a, material.g, nv, brdf_share(nv, material.r));
    out_radiance = vec4(texelFetch(irradiance, pixel, 0).rgb * (reflects.diffuse + reflects.specular) * 0.31830988618, 1.0);
}
