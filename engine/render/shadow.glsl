// How much of a light reaches a point, by its map.
#ifndef LANTHORN_SHADOW_GLSL
#define LANTHORN_SHADOW_GLSL
#include "light_map.glsl"

uniform sampler2DArray light_map_distance;
uniform sampler2DArray light_map_normals;
uniform sampler2DArray area_map_distance;
uniform sampler2DArray area_map_normals;

// A layer of a light's map: its axes (right, up scaled so that the map's edge is at 1) and what kind it is.
struct ShadowFrame {
    vec3 right;
    vec3 up;
    vec3 forward;
    bool parallel;  // directional
};

ShadowFrame shadow_frame(LightData light, int layer) {
    if (light.layers != 6u) {
        return ShadowFrame(light.right * light.extent, light.up * light.extent, light.direction,
                           light.type == kLightDirectional);
    }
    int face = layer - int(light.first_layer);  // cube.glsl's table in arithmetic
    bool x = face < 2;
    bool y = face == 2 || face == 3;
    float s = (face & 1) == 0 ? 1.0 : -1.0;
    return ShadowFrame(x ? vec3(0.0, 0.0, s) : vec3(y ? s : -s, 0.0, 0.0), y ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0),
                       x ? vec3(s, 0.0, 0.0) : (y ? vec3(0.0, s, 0.0) : vec3(0.0, 0.0, s)), false);
}

// 1 where the map saw nothing nearer than `distance`.
vec4 shadow_lit(vec4 stored, float distance) {
    return vec4(1.0) - vec4(greaterThan(stored, vec4(0.0))) * vec4(lessThan(stored, vec4(distance)));
}

// Takes the nearest of four texels that shade, if nearer than xy's (z: its distance), in textureGather's order.
vec3 shadow_nearest(vec3 nearest, vec4 stored, vec4 lit, vec2 corner) {
    vec4 s = mix(stored, vec4(3e38), lit);
    float m = min(min(s.x, s.y), min(s.z, s.w));
    vec2 at = corner - vec2(s.y == m || s.z == m ? 0.0 : 1.0, s.x == m || s.y == m ? 0.0 : 1.0);
    return m < nearest.z ? vec3(at, m) : nearest;
}

// Where the texel `at` of a layer saw something `distance` away, from the light.
vec3 shadow_point(ShadowFrame frame, ivec2 at, vec2 size, float distance) {
    vec2 p = (vec2(at) + 0.5) * 2.0 / size - 1.0;
    vec3 side = frame.right * p.x + frame.up * p.y;
    vec3 ray = frame.forward + side;
    return frame.parallel ? side + frame.forward * distance : ray * (distance * inversesqrt(dot(ray, ray)));
}

// The plane of what the map holds at `texel`: dot(xyz, q) + w is how far a point is in front of it, up to a factor of 0.6 to 1.
vec4 shadow_plane(sampler2DArray map_normals, ShadowFrame frame, vec3 texel, vec2 size, int layer) {
    ivec2 at = clamp(ivec2(texel.xy), ivec2(0), ivec2(size) - 1);
    vec2 e = texelFetch(map_normals, ivec3(at, layer), 0).rg;
    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));  // octahedral_decode, but for the length
    float fold = max(-n.z, 0.0);
    n.xy += mix(vec2(fold), vec2(-fold), greaterThanEqual(n.xy, vec2(0.0)));
    return vec4(n, -dot(shadow_point(frame, at, size, texel.z), n));
}

// How far `q` is in front of a plane that shades it. Near the edge where two walls meet a point is farther than its neighbours in the
// map, yet not in their shadow: it is in front of them. Where it has come there only by being lifted, it is as far behind as it was,
// unless the plane is that of its own surface.
float shadow_in_front(vec4 plane, vec3 q, vec3 lift) {
    float along = dot(plane.xyz, lift);
    float front = dot(plane.xyz, q) + plane.w;
    bool crossed = front >= 0.0 && front < along && along * along < 0.8 * dot(lift, lift) * dot(plane.xyz, plane.xyz);
    return crossed ? front - along : front;
}

// What of 4 x 4 texels from `first` on, weighed by `wx` and `wy`, is lit and lies in the plane that shades `q` or in front
// of it: that plane stands on q's surface, and they show both on its other side, however thin it is. Rare: a loop, so that others run
// through none.
float shadow_beyond(sampler2DArray map, ShadowFrame frame, vec2 first, vec4 wx, vec4 wy, vec2 size, int layer,
                    float distance, vec4 plane, float front) {
    float sum = 0.0;
    float reach = 4.0 / size.x * length(frame.right) * (frame.parallel ? 1.0 : distance);  // two texels: no farther do they look
    int k = front > -reach ? 0 : 16;
    while (k < 16) {
        ivec2 within = ivec2(k % 4, k / 4);
        ivec2 at = clamp(ivec2(first) + within, ivec2(0), ivec2(size) - 1);
        float stored = texelFetch(map, ivec3(at, layer), 0).r;
        float before = dot(shadow_point(frame, at, size, stored), plane.xyz) + plane.w;
        bool beyond = stored >= distance && before > 0.5 * front;
        sum += beyond ? wx[within.x] * wy[within.y] : 0.0;
        ++k;
    }
    return sum;
}

// Bilinear over 2x2 texels.
float shadow_2x2(sampler2DArray map, sampler2DArray map_normals, ShadowFrame frame, vec2 uv, int layer, vec3 q,
                 float distance) {
    vec2 size = vec2(textureSize(map, 0).xy);
    vec2 t = uv * size - 0.5;
    vec2 base = floor(t);
    vec2 f = t - base;
    vec4 stored = textureGather(map, vec3((base + 1.0) / size, float(layer)));
    vec4 lit = shadow_lit(stored, distance);
    vec3 nearest = shadow_nearest(vec3(base, 3e38), stored, lit, base + 1.0);
    vec4 plane = shadow_plane(map_normals, frame, nearest, size, layer);
    if (dot(plane.xyz, q) + plane.w >= 0.0) return 1.0;
    return mix(mix(lit.w, lit.z, f.x), mix(lit.x, lit.y, f.x), f.y);
}

// Mean of 3x3 bilinear taps, from 4x4 texels in four gathers.
float shadow_3x3(sampler2DArray map, sampler2DArray map_normals, ShadowFrame frame, vec2 uv, int layer, vec3 q,
                 vec3 lift, float distance) {
    vec2 size = vec2(textureSize(map, 0).xy);
    vec2 t = uv * size - 0.5;
    vec2 base = floor(t);
    vec2 f = t - base;
    float sum = 0.0;
    vec3 nearest = vec3(base, 3e38);
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) {
            vec2 corner = base + 2.0 * vec2(i, j);
            vec4 stored = textureGather(map, vec3(corner / size, float(layer)));
            vec4 lit = shadow_lit(stored, distance);
            nearest = shadow_nearest(nearest, stored, lit, corner);
            vec2 x = i == 0 ? vec2(1.0 - f.x, 1.0) : vec2(1.0, f.x);
            vec2 y = j == 0 ? vec2(1.0 - f.y, 1.0) : vec2(1.0, f.y);
            sum += (lit.w * x.x + lit.z * x.y) * y.x + (lit.x * x.x + lit.y * x.y) * y.y;
        }
    }
    vec4 plane = shadow_plane(map_normals, frame, nearest, size, layer);
    float front = shadow_in_front(plane, q, lift);
    if (front >= 0.0 || sum <= 0.0 || sum >= 9.0) return front >= 0.0 ? 1.0 : sum / 9.0;
    vec4 wx = vec4(1.0 - f.x, 1.0, 1.0, f.x);
    vec4 wy = vec4(1.0 - f.y, 1.0, 1.0, f.y);
    return (sum - shadow_beyond(map, frame, base - 1.0, wx, wy, size, layer, distance, plane, front)) / 9.0;
}

// The point lifted off its surface by what `texels` of the map can differ in depth on the surface's own plane: in
// texels, so at every scale alike.
vec3 shadow_lifted(LightData light, float texels, vec3 point, vec3 normal, vec3 to_light, float distance) {
    float cosine = clamp(dot(normal, to_light), 0.0, 1.0);
    float texel = light.type == kLightDirectional ? light.texel : light.texel * distance;
    return point + normal * (texel * (texels * sqrt(1.0 - cosine * cosine) + 0.02));
}

// How much of a point, spot or directional light reaches `point`, 0..1; `normal`: unit geometric normal there;
// `to_light` and `distance` from punctual_illuminance().
float punctual_visibility(LightData light, vec3 point, vec3 normal, vec3 to_light, float distance) {
#ifdef SHARED_MAPS
    // By another lamp's map, as that one is seen; from behind it would tell nothing.
    light.position += light.map_offset;
    vec3 to_map = light.position - point;
    bool shares = light.shares_map != 0u;
    distance = shares ? length(to_map) : distance;
    to_light = shares ? to_map / max(distance, 1e-30) : to_light;
    if (shares && dot(normal, to_map) <= 0.0) return 1.0;
#endif
    vec3 lifted = shadow_lifted(light, 3.0, point, normal, to_light, distance);
    int layer;
    vec2 uv;
    bool inside = light_map_lookup(light, lifted, layer, uv);
    vec3 q = lifted - light.position;
    float stored = light.type == kLightDirectional ? dot(q, light.direction) : length(q);
    ShadowFrame frame = shadow_frame(light, layer);
    float lit = shadow_3x3(light_map_distance, light_map_normals, frame, uv, layer, q, lifted - point, stored);
    return inside ? lit : 1.0;
}

// The same for an area sample.
float area_visibility(LightData light, vec3 point, vec3 normal, vec3 to_light, float distance) {
    vec3 q = shadow_lifted(light, 1.5, point, normal, to_light, distance) - light.position;
    vec3 face_uv = cube_face_uv(q);
    int layer = int(light.first_layer) + int(face_uv.z);
    ShadowFrame frame = shadow_frame(light, layer);
    return shadow_2x2(area_map_distance, area_map_normals, frame, face_uv.xy, layer, q, length(q));
}

#endif
