// The lamps that light a point, of many: groups and single lamps by a walk through their tree (lamp_tree.h), which needs no memory.
// What is passed over gives nothing; a group is taken for one lamp where that is exact to the second moments of its places.
#ifndef LANTHORN_LAMP_TREE_GLSL
#define LANTHORN_LAMP_TREE_GLSL
#include "lights.glsl"

uniform samplerBuffer lamp_nodes;
uniform usamplerBuffer lamp_lights;  // `lights` as texels, which software rasterisers read several times faster
uniform float lamp_closeness;  // the largest radius of a group over its distance, squared
uniform float lamp_texel;      // LightData::texel of cubes

// What a walk sees at a node.
struct LampLook {
    bool none;   // it gives no light: passed over
    bool whole;  // it may be taken as it is; else the walk goes into it
    int past;    // the node behind it and all below it
};

// int NAME(AT at, int i, int end, out int next): from node `i` on the next one that is taken; `end` if there is none. `next`: where
// to go on. LampLook LOOK(AT at, int i). The walk says itself when it has ended, by `going`: llvmpipe (Mesa 22.3) goes on to alter
// what a lane has found while its neighbours still look.
#define LAMP_WALK(NAME, AT, LOOK)                                        \
    int NAME(AT at, int i, int end, out int next) {                      \
        int taken = end;                                                 \
        do {                                                             \
            LampLook look = LOOK(at, i);                                 \
            bool going = taken == end && i < end;                        \
            taken = going && look.whole && !look.none ? i : taken;       \
            i = !going ? i : look.none || look.whole ? look.past : i + 1; \
        } while (taken == end && i < end);                               \
        next = i;                                                        \
        return taken;                                                    \
    }

// A point as the walk sees it.
struct LampTarget {
    vec3 point;
    vec3 geometric;  // unit normals; no light comes from behind the geometric one
    vec3 shading;
    vec3 v;       // unit, to the viewer
    float lobe2;  // squared width of the specular lobe; 0: there is none
};

LampTarget matte_target(vec3 point, vec3 normal) { return LampTarget(point, normal, normal, normal, 0.0); }

// Whether the group may be taken for one as far as the lobe goes: half vectors turn by half the group's angle, less than the
// lobe or their distance from it.
bool within_lobe(LampTarget at, vec3 l, float angle2) {
    vec3 h = l + at.v;
    float hh = dot(h, h);
    float nh = dot(at.shading, h);
    float nh2 = nh * nh;
    return at.lobe2 <= 0.0 || angle2 * nh2 <= 4.0 * lamp_closeness * (max(hh - nh2, 0.0) + at.lobe2 * nh2);
}

LampLook look_at_lamps(LampTarget at, int i) {
    vec4 place = texelFetch(lamp_nodes, kLampNodeTexels * i);
    vec4 bounds = texelFetch(lamp_nodes, kLampNodeTexels * i + 1);
    vec3 to = place.xyz - at.point;
    float d2 = dot(to, to);
    float r2 = place.w * place.w;
    float above = dot(to, at.geometric);
    bool none = d2 > bounds.x || above <= -place.w;
    bool near = r2 > lamp_closeness * d2 || d2 > bounds.y || min(abs(above), abs(dot(to, at.shading))) < place.w;
    bool whole = !near && within_lobe(at, to * inversesqrt(max(d2, 1e-30)), r2 / max(d2, 1e-30));
    return LampLook(none, whole, int(bounds.z));
}

// The same of nodes of lamps that make no groups, which a cone bounds.
LampLook look_at_spot(LampTarget at, int i) {
    vec4 place = texelFetch(lamp_nodes, kLampNodeTexels * i);
    vec4 bounds = texelFetch(lamp_nodes, kLampNodeTexels * i + 1);
    vec4 cone = texelFetch(lamp_nodes, kLampNodeTexels * i + 2);
    vec3 to = place.xyz - at.point;
    float d2 = dot(to, to);
    float along = -dot(to, cone.xyz);
    float across = sqrt(max(d2 - along * along, 0.0));
    float sine = sqrt(max(1.0 - cone.w * cone.w, 0.0));
    bool outside = cone.w > 0.0 && across * cone.w - along * sine > place.w + 1e-5 * (abs(along) + across);
    bool none = outside || d2 > bounds.x || dot(to, at.geometric) <= -place.w;
    return LampLook(none, bounds.y > 0.0, int(bounds.z));
}

LAMP_WALK(next_lamps, LampTarget, look_at_lamps)
LAMP_WALK(next_spot, LampTarget, look_at_spot)

// A ray of the eye, in air that scatters light.
struct LampRay {
    vec3 from;
    vec3 along;  // unit
    float far;
};

// For the light along a ray: groups have half the size, as their moments are left out.
LampLook look_at_lamps(LampRay at, int i) {
    vec4 place = texelFetch(lamp_nodes, kLampNodeTexels * i);
    vec4 bounds = texelFetch(lamp_nodes, kLampNodeTexels * i + 1);
    vec3 to = place.xyz - at.from;
    float along = dot(to, at.along);
    vec3 nearest = to - at.along * clamp(along, 0.0, at.far);
    float d2 = dot(nearest, nearest);
    float farthest = max(dot(to, to), dot(to, to) + at.far * (at.far - 2.0 * along));
    bool whole = 4.0 * place.w * place.w <= lamp_closeness * d2 && farthest <= bounds.y;
    return LampLook(d2 > bounds.x, whole, int(bounds.z));
}

LampLook look_at_spot(LampRay at, int i) {
    vec4 place = texelFetch(lamp_nodes, kLampNodeTexels * i);
    vec4 bounds = texelFetch(lamp_nodes, kLampNodeTexels * i + 1);
    vec3 to = place.xyz - at.from;
    vec3 nearest = to - at.along * clamp(dot(to, at.along), 0.0, at.far);
    return LampLook(dot(nearest, nearest) > bounds.x, bounds.y > 0.0, int(bounds.z));
}

LAMP_WALK(next_lamps, LampRay, look_at_lamps)
LAMP_WALK(next_spot, LampRay, look_at_spot)

// A node's lamps as one point lamp at their mean place, its shadows those of its speaker.
LightData point_lamp(vec3 place, vec4 intensity, vec4 map) {
    LightData light;
    light.position = place;
    light.range = intensity.w;
    light.direction = vec3(0.0, -1.0, 0.0);
    light.type = kLightPoint;
    light.intensity = intensity.rgb;
    light.area = 0.0;
    light.right = vec3(1.0, 0.0, 0.0);
    light.cone_scale = 0.0;
    light.up = vec3(0.0, 0.0, 1.0);
    light.cone_offset = 0.0;
    light.extent = 1.0;
    light.cos_outer = -1.0;
    light.first_layer = uint(map.w);
    light.layers = 6u;
    light.id = 0u;
    light.depth_range = 0.0;
    light.texel = lamp_texel;
    light.two_sided = 0u;
    light.map_offset = map.xyz;
    light.shares_map = 1u;
    return light;
}

// First texel of a node; if none was found, of the first one.
int lamp_node(int node, bool found) { return found ? kLampNodeTexels * node : 0; }

LightData lamps_of(int node, LampRay at, bool found) {
    int texel = lamp_node(node, found);
    vec4 intensity = texelFetch(lamp_nodes, texel + 2);
    intensity.rgb = found ? intensity.rgb : vec3(0.0);
    return point_lamp(texelFetch(lamp_nodes, texel).xyz, intensity, texelFetch(lamp_nodes, texel + 3));
}

// As bright as they are to the second moments of their places: sum f(r + d) = f(r) + 1/2 f''(r) : sum d d, f(r) = n.r / |r|^3.
LightData lamps_of(int node, LampTarget at, bool found) {
    int texel = lamp_node(node, found);
    vec4 place = texelFetch(lamp_nodes, texel);
    vec4 intensity = texelFetch(lamp_nodes, texel + 2);
    vec4 m0 = texelFetch(lamp_nodes, texel + 4);
    vec4 m1 = texelFetch(lamp_nodes, texel + 5);
    vec3 to = place.xyz - at.point;
    float d2 = max(dot(to, to), 1e-30);
    vec3 u = to * inversesqrt(d2);
    vec3 mu = vec3(m0.x * u.x + m0.w * u.y + m1.x * u.z, m0.w * u.x + m0.y * u.y + m1.y * u.z, m1.x * u.x + m1.y * u.y + m0.z * u.z);
    float cosine = dot(at.shading, u);
    float by_moments = 7.5 * dot(u, mu) - 1.5 * (m0.x + m0.y + m0.z) - 3.0 * dot(at.shading, mu) / max(cosine, 1e-3);
    float k = place.w > 0.0 && cosine > 0.0 ? clamp(1.0 + by_moments / d2, 0.5, 2.0) : 1.0;
    intensity.rgb *= found ? k : 0.0;
    return point_lamp(place.xyz, intensity, texelFetch(lamp_nodes, texel + 3));
}

// Lamp of a node that next_spot() took.
LightData spot_of(int node, bool found) {
    LightData light = light_in_texels(lamp_lights, int(texelFetch(lamp_nodes, lamp_node(node, found) + 1).w));
    light.intensity = found ? light.intensity : vec3(0.0);
    return light;
}

// Its kind known.
LightData narrow_spot_of(int node, bool found) {
    LightData light = spot_of(node, found);
    light.type = kLightSpot;
    light.layers = 1u;
    return light;
}

// The squared distance to the nearest lamp of the nodes `begin` to `end`, not above `near`.
float nearest_lamp(vec3 point, int begin, int end, float near) {
    int i = begin;
    do {
        vec4 place = texelFetch(lamp_nodes, kLampNodeTexels * i);
        float next = texelFetch(lamp_nodes, kLampNodeTexels * i + 1).z;
        float d = distance(place.xyz, point);
        float least = max(d - place.w, 0.0);
        bool going = i < end;
        near = going ? min(near, (d + place.w) * (d + place.w)) : near;
        i = !going ? i : least * least > near || place.w == 0.0 ? int(next) : i + 1;
    } while (i < end);
    return near;
}

#endif
