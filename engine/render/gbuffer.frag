#version 450 core
#include "material.glsl"
#include "camera.glsl"
#include "gbuffer_flags.glsl"
#include "octahedral.glsl"
#ifdef WITH_LOOK
#include "dither.glsl"

uniform float look_shown;  // Look
uniform float look_rim;    // 0 or 1
#endif

layout(location = 0) out float out_distance;
layout(location = 1) out vec4 out_normals;
layout(location = 2) out vec4 out_albedo;
layout(location = 3) out vec4 out_material;
layout(location = 4) out vec4 out_emissive;

uniform float emissive_scale;
#ifdef BLENDED
uniform sampler2D distance_behind;  // of what is solid; 0: nothing

const float kClearAlpha = 1.0 / 64.0;  // below it nothing is seen of a surface
#endif

void main() {
    vec3 relative = scene.position - camera_position;
    vec3 towards = camera_orthographic != 0 ? -camera_forward : -relative;
    vec3 geometric = geometric_direction(towards, scene.normal);
    SurfaceMaterial m = evaluate_material();
    vec3 shading = shading_normal(gl_FrontFacing);
#ifdef BLENDED
    float behind = texelFetch(distance_behind, ivec2(gl_FragCoord.xy), 0).r;
    bool hidden = behind > 0.0 && camera_distance(relative) >= behind;
    if (hidden || m.alpha < kClearAlpha || m.alpha >= kSolidAlpha) discard;
#elif defined(MASKED)  // a shader that may discard tests depth late, even where it does not
    if (material_not_solid(m.alpha)) discard;
#endif
#ifdef WITH_LOOK
    if (look_shown < dither_threshold(ivec2(gl_FragCoord.xy))) discard;
#endif
    out_distance = camera_distance(relative);
    out_normals = vec4(octahedral_encode(shading), octahedral_encode(geometric));
    out_albedo = vec4(m.base_colour * mix(1.0 - m.transmission, 1.0, m.metallic), m.metallic);
    float flags = gbuffer_flags(m.unlit, m.transmission, m.base_colour);
#ifdef WITH_LOOK
    if (flags == 0.0) flags = look_rim;
#endif
    out_material = vec4(m.roughness, m.f0, m.occlusion, flags);
    out_emissive = vec4(m.emissive / emissive_scale, m.transmission * (1.0 - m.metallic));
}
