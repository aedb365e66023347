// What stands between a sample and a point, by the map of distances about the sample (sample_pictures.h).
#ifndef LANTHORN_DRM_HIDDEN_SAMPLE_GLSL
#define LANTHORN_DRM_HIDDEN_SAMPLE_GLSL

#include "radiance_sample.h"
#include "engine/render/shadow.glsl"

uniform sampler2DArray hiding_distance;
uniform sampler2DArray hiding_normals;

// How much of a sample is seen from `x`, 0..1; `normal`: unit, of the surface there.
float visibility_of_sample(RadianceSample s, vec3 x, vec3 normal) {
    LightData light;
    light.type = kLightAreaSample;
    light.layers = 6u;
    light.first_layer = uint(s.picture);
    light.texel = 2.0 / float(textureSize(hiding_distance, 0).x);
    vec3 way = s.place - x;
    float distance = length(way);
    vec3 q = shadow_lifted(light, 1.5, x, normal, way / max(distance, 1e-30), distance) - s.place;
    vec3 face_uv = cube_face_uv(q);
    int layer = s.picture + int(face_uv.z);
    ShadowFrame frame = shadow_frame(light, layer);
    return shadow_2x2(hiding_distance, hiding_normals, frame, face_uv.xy, layer, q, length(q));
}

#endif
