#version 450 core
// Photons leave the lights and scatter at their first surface (Yao et al. 2010, sec. 7): punctual lights through their own
// maps, which are reflective shadow maps; emissive triangles (EMISSIVE 1: there are some) and the sky (SKY 1) through the
// environment maps. The sky's arrivals at first surfaces are indirect light and stored, after those of all bounces; so are those of
// some emissive triangles (FIRST 1), whose direct light nothing else brings.
layout(local_size_x = 64) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "photon.glsl"
#include "engine/render/random.glsl"
#include "engine/render/light_map.glsl"
#include "engine/render/include/lanthorn/render/emissive_data.h"
#include "scatter.glsl"
#include "surface_bsdf.glsl"
#define BAD_VALUES_BINDING 5
#include "gi_module/shared/bad_values.glsl"
#if SKY
#define SKY_CELLS_BINDING 6
#include "sky_photons.glsl"
#endif
#if SKY || FIRST
layout(std430, binding = 1) writeonly buffer Hits { PhotonHit hits[]; };
#if DIRECTIONS
layout(std430, binding = 8) writeonly buffer Directions { uint directions[]; };  // PhotonSet::directions
#endif

uniform int first_arrival;  // where those at first surfaces are stored
uniform float bandwidth;    // their radius, metres
#endif
#if FIRST
layout(std430, binding = 7) readonly buffer FirstOf { uint first_of[]; };  // by emissive triangle: whether its are
#endif

layout(std430, binding = 0) writeonly buffer Rays { PhotonRay rays[]; };
layout(std430, binding = 3) readonly buffer Emissive { EmissiveTriangleData emissive_triangles[]; };

uniform sampler2DArray light_distance;
uniform sampler2DArray light_normals;
uniform sampler2DArray light_albedo;
uniform int photon_count;
uniform int source_count;
uniform isamplerBuffer sources;  // first photon, photons, light (-1: emissive, -2: the sky), key
uniform int emissive_count;
uniform float emissive_flux;  // luminance-weighted, lumen
uniform vec4 surroundings;    // a sphere around them: middle, radius; 0: of a scene that has none
uniform uint seed;
uniform uint pass_index;  // passes before this one of a still picture

const float kReached = 0.995;  // of a photon's way, that a look back must find free

// Two low-discrepancy numbers of the j-th photon of a source (R2, Roberts 2018), exact in 32 bits for every j.
vec2 emission_numbers(uint j) {
    uvec2 u = (j + 1u) * uvec2(3242174889u, 2447445414u) + pcg4d(uvec4(seed, 11u, 13u, 17u)).xy;
    return vec2(u >> 8u) * (1.0 / 16777216.0);
}

#if SKY
// Three of them (R3), of a photon of the sky.
vec3 sky_numbers(uint j) {
    uvec3 u = (j + 1u) * uvec3(3518319155u, 2882110345u, 2360945575u) + pcg4d(uvec4(seed, 19u, 31u, 37u)).xyz;
    return vec3(u >> 8u) * (1.0 / 16777216.0);
}
#endif

// The plane that a texel of a light's map shows: its normal, and how far along `direction` from `origin` it lies; < 0: it shows none.
float light_texel_plane(LightData light, ivec3 texel, vec3 origin, vec3 direction, out vec3 normal, out vec3 point) {
    vec2 size = vec2(textureSize(light_distance, 0).xy);
    float stored = texelFetch(light_distance, texel, 0).r;
    normal = octahedral_decode(texelFetch(light_normals, texel, 0).rg);
    vec3 centre_origin;
    vec3 centre_direction;
    light_map_ray(light, texel.z - int(light.first_layer), (vec2(texel.xy) + 0.5) / size, centre_origin, centre_direction);
    point = centre_origin + centre_direction * stored;
    return stored > 0.0 ? dot(normal, point - origin) / min(dot(normal, direction), -1e-6) : -1.0;
}

// A first hit of a photon of a punctual light, off its map, and what of that the map keeps. False: it meets nothing.
bool emit_punctual(LightData light, vec2 u, float share, out vec3 position, out vec3 normal, out vec3 direction, out vec4 kept, out vec3 power) {
    vec3 origin = light.position + light.map_offset;  // from where its map is seen
    direction = light.direction;
    kept = vec4(0.0);
    vec3 from_light;  // not a point: its fp32 steps would coarsen the direction of a light far from the origin
    power = light.intensity * share;
    if (light.type == kLightDirectional) {
        vec2 disc = sqrt(u.x) * vec2(cos(6.28318530718 * u.y), sin(6.28318530718 * u.y)) * light.extent;
        from_light = light.right * disc.x + light.up * disc.y;
        origin += from_light;
        power *= 3.14159265359 * light.extent * light.extent;
    } else {
        float cos_outer = light.type == kLightSpot ? light.cos_outer : -1.0;
        float z = mix(1.0, cos_outer, u.x);
        float r = sqrt(max(1.0 - z * z, 0.0));
        vec3 axis = light.type == kLightSpot ? light.direction : vec3(0.0, 0.0, 1.0);
        vec3 t = normalize(abs(axis.x) < 0.5 ? vec3(0.0, -axis.z, axis.y) : vec3(-axis.y, axis.x, 0.0));
        direction = axis * z + (t * cos(6.28318530718 * u.y) + cross(axis, t) * sin(6.28318530718 * u.y)) * r;
        from_light = direction;
        power *= 6.28318530718 * (1.0 - cos_outer) * light_cone(light, direction);
    }
    int layer;
    vec2 uv;
    position = origin;
    normal = -direction;
    if (!light_map_lookup_from_light(light, from_light, layer, uv)) return false;
    ivec2 size = textureSize(light_distance, 0).xy;
    ivec3 texel = ivec3(clamp(ivec2(uv * vec2(size)), ivec2(0), size - 1), layer);
    float stored = texelFetch(light_distance, texel, 0).r;
    if (!(stored > 0.0)) return false;
    // The distance along this very direction: the texel's plane, not its centre.
    vec3 point;
    float t = light_texel_plane(light, texel, origin, direction, normal, point);
    t = dot(normal, direction) < -0.02 ? clamp(t, 0.8 * stored, 1.25 * stored) : stored;
    // Beside a concave edge the texel may show one wall where the photon meets the other: the nearer plane is the surface.
    vec2 within = uv * vec2(size) - vec2(texel.xy) - 0.5;
    ivec3 own = texel;
    vec3 own_normal = normal;
    for (int k = 0; k < 2; ++k) {
        ivec2 towards = k == 0 ? ivec2(within.x < 0.0 ? -1 : 1, 0) : ivec2(0, within.y < 0.0 ? -1 : 1);
        ivec3 beside = ivec3(clamp(own.xy + towards, ivec2(0), size - 1), own.z);
        vec3 other_normal;
        vec3 other;
        float other_t = light_texel_plane(light, beside, origin, direction, other_normal, other);
        float slack = 1e-3 * stored;
        bool concave = dot(point - other, other_normal) > slack && dot(other - point, own_normal) > slack;
        bool nearer = concave && other_t > 0.8 * stored && other_t < t;
        t = nearer ? other_t : t;
        normal = nearer ? other_normal : normal;
        texel = nearer ? beside : texel;
    }
    position = origin + direction * t;
    if (light.type != kLightDirectional) power *= light_range_window(light, t);
    kept = texelFetch(light_albedo, texel, 0);
    return true;
}

// A point and direction of an emissive triangle chosen by flux; power of one photon. Gives its number.
int emit_surface(vec2 u, vec4 v, float share, out vec3 position, out vec3 normal, out vec3 power) {
    int low = 0;
    int high = emissive_count - 1;
    while (low < high) {
        int middle = (low + high) / 2;
        if (emissive_triangles[middle].p0.w < u.x) low = middle + 1;
        else high = middle;
    }
    EmissiveTriangleData triangle = emissive_triangles[low];
    float before = low > 0 ? emissive_triangles[low - 1].p0.w : 0.0;
    float s = clamp((u.x - before) / max(triangle.p0.w - before, 1e-12), 0.0, 1.0);  // the choice's remainder, used again
    float root = sqrt(s);
    vec3 b = vec3(1.0 - root, root * (1.0 - u.y), root * u.y);
    position = triangle.p0.xyz * b.x + triangle.p1.xyz * b.y + triangle.p2.xyz * b.z;
    vec3 e1 = triangle.p1.xyz - triangle.p0.xyz;
    vec3 e2 = triangle.p2.xyz - triangle.p0.xyz;
    normal = normalize(cross(e1, e2));
    bool both = triangle.p1.w > 0.5;
    if (both && v.z < 0.5) normal = -normal;
    float sides = both ? 2.0 : 1.0;
    float probability = max(triangle.p2.w / emissive_flux, 1e-12);
    power = triangle.radiance.rgb * (3.14159265359 * triangle.radiance.w * sides * share / probability);
    return low;
}

#if EMISSIVE
// Whether some map sees the side of the surface at x. What none sees may lie in a wall that the emitter sticks into.
bool is_seen(vec3 x, vec3 n) {
    bool seen = false;
    for (int s = 0; s < map_count; ++s) seen = seen || (slot_in_use(s, 0.0) && sees_side(s, x + n * origin_offset(), n));
    return seen;
}

bool is_far(vec3 x) {
    vec3 to = surroundings.xyz - x;
    return surroundings.w > 0.0 && dot(to, to) > 4.0 * surroundings.w * surroundings.w;
}

// The direction of a photon of a surface. From far off every other one is aimed at the surroundings, which few would meet else;
// its power is that of both ways together (balance heuristic, Veach and Guibas 1995).
vec3 emitted_direction(vec3 x, vec3 n, vec3 u, inout vec3 power) {
    if (!is_far(x)) return cosine_direction(n, u.xy);
    const float pi = 3.14159265359;
    vec3 to = surroundings.xyz - x;
    float sine2 = surroundings.w * surroundings.w / dot(to, to);
    float height = sine2 / (1.0 + sqrt(1.0 - sine2));
    vec3 axis = normalize(to);
    bool aimed = u.z < 0.5;
    vec3 d = cosine_direction(n, u.xy);
    if (aimed) {
        float down = u.x * height;
        float r = sqrt(down * (2.0 - down));
        vec3 t = normalize(abs(axis.x) < 0.5 ? vec3(0.0, -axis.z, axis.y) : vec3(-axis.y, axis.x, 0.0));
        d = axis * (1.0 - down) + (t * cos(2.0 * pi * u.y) + cross(axis, t) * sin(2.0 * pi * u.y)) * r;
    }
    vec3 off = cross(d, axis);
    bool within = aimed || (dot(off, off) < sine2 && dot(d, axis) > 0.0);
    float cosine = max(dot(d, n), 0.0) / pi;
    power *= cosine / max(0.5 * cosine + (within ? 0.25 / (pi * height) : 0.0), 1e-30);
    return d;
}
#endif

// The map that a photon asks first: one on its side of the surface that it starts from.
int map_before(vec3 x, vec3 n) {
    int s = 0;
    while (s < map_count && !(slot_in_use(s, 0.0) && sees_side(s, x + n * origin_offset(), n))) ++s;
    return s < map_count ? s : 0;
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= photon_count) return;
    ivec4 source = texelFetch(sources, 0);
    for (int k = 1; k < source_count && i >= texelFetch(sources, k).x; ++k) source = texelFetch(sources, k);
    uint j = uint(i - source.x) + pass_index * uint(source.y);
    uint number = j + uint(source.w);  // a light's photons keep theirs, whatever becomes of the other lights
    float share = 1.0 / float(source.y);
    vec2 u = emission_numbers(j);
    vec4 v = scatter_numbers(seed, number, 0u);
    vec3 position;
    vec3 normal;
    vec3 power;
    vec3 direction = vec3(0.0);  // in which it comes to its first surface
    vec4 kept = vec4(0.0);
    float choice = v.z;
    int slot = 0;
    bool alive = false;
#if SKY || FIRST
    PhotonHit stored;
    stored.position = vec3(0.0);
    stored.radius = 0.0;
    stored.power = vec3(0.0);
    stored.normal = 0u;
#endif
    if (source.z >= 0) {
        alive = emit_punctual(lights[source.z], u, share, position, normal, direction, kept, power);
        slot = map_before(position, normal);
    }
#if EMISSIVE
    if (source.z == -1) {
        vec4 w = random4(seed, number, 0u, 3u);
        choice = w.w;  // v.z has chosen a side
        int triangle = emit_surface(u, v, share, position, normal, power);
        bool far = is_far(position);
        direction = emitted_direction(position, normal, w.xyz, power);
        SceneHit hit = intersect_all(position + normal * origin_offset(), normal, direction, ray_start(), 0, v.w);
        if (hit.found && (far || !is_seen(position, normal))) {  // what stands before it may show its back to all maps
            SceneHit back = intersect_all(hit.position + hit.normal * origin_offset(), hit.normal, -direction, ray_start(), hit.slot, v.w);
            hit.found = !back.found || back.t > (far ? 0.9 : kReached) * hit.t;
        }
        alive = hit.found;
        position = hit.position;
        normal = hit.normal;
        slot = hit.slot;
        kept = hit.kept;
#if FIRST
        if (hit.found && first_of[triangle] != 0u && !is_bad(power) && !is_bad(position)) {
            stored.position = position;
            stored.radius = bandwidth;
            stored.power = power;
            stored.normal = pack_normal(normal);
        }
#endif
    }
#endif
#if SKY
    if (source.z == -2) {
        vec3 entry;
        vec3 to_sky;
        sky_photon(sky_numbers(j), random4(seed, number, 0u, 3u).xy, entry, to_sky, power);
        power *= share;
        SceneHit hit = sky_photon_hit(entry, to_sky, v.w);
        alive = hit.found;
        position = hit.position;
        normal = hit.normal;
        slot = hit.slot;
        if (hit.found && !is_bad(power) && !is_bad(position)) {
            stored.position = position;
            stored.radius = bandwidth;
            stored.power = power;
            stored.normal = pack_normal(normal);
        }
        direction = -to_sky;
        kept = hit.kept;
    }
#endif
#if SKY || FIRST
    hits[first_arrival + i] = stored;
#if DIRECTIONS
    directions[first_arrival + i] = pack_normal(direction);
#endif
#endif
    Scattered on = scatter_kept(kept_surface(kept), normal, -direction, vec3(v.xy, choice));
    if (alive) power *= on.weight;  // lost photons keep what they carried, for the energy balance
    if (is_bad(power) || is_bad(position)) {
        atomicAdd(bad_value_count, 1u);
        power = vec3(0.0);
        alive = false;
    }
    PhotonRay ray;
    ray.origin = position + normal * origin_offset();
    ray.start = start_bits(slot, normal);
    ray.direction = vec4(on.direction, alive ? on.density : 0.0);
    ray.power = power;
    ray.number = number;
    rays[i] = ray;
}
