// Light of an area sample on surfaces so near to it that a point says little of it: of what it stands for, in ever smaller parts
// (near_emitters.h), down to triangles by Lambert's sum over their edges (Lambert 1760; Baum, Rushmeier and Winget 1989, eq. 5).
#ifndef LANTHORN_NEAR_EMITTERS_GLSL
#define LANTHORN_NEAR_EMITTERS_GLSL
#include "shining_lights.glsl"

uniform samplerBuffer emitter_nodes;

const float kEmitterNear = 3.0;  // radii of a part to its middle, below which one looks at what it is made of
const float kEmitterBlend = 0.5;  // radii more, from where on the sample's point says it all
const float kEmitterSpread = 0.5;  // sine, up to which normals count as one where some of them face the point and some do not

// What falls on a surface.
struct NearLight {
    vec3 irradiance;  // lux
    vec3 flow;        // from where, and how wide: the vector irradiance of 1 nit over pi, of a ball its angular radius' squared sine
};

// 1 where the sample's point is no measure of it, 0 where it is; between in between. One of no intensity is left to others.
float emitter_nearness(LightData light, vec3 point) {
    vec3 d = light.up - point;
    float far = kEmitterNear + kEmitterBlend - sqrt(dot(d, d) / max(light.depth_range * light.depth_range, 1e-30));
    bool shines = light.cone_offset > light.cone_scale && light.intensity != vec3(0.0);
    return shines ? clamp(far / kEmitterBlend, 0.0, 1.0) : 0.0;
}

#ifdef WITH_AREA
// The next area sample from `i` on that the point is near to; light_end: there is none.
int next_near_emitter(int i, vec3 point) {
    int found = light_end;
    do {
        bool near = found == light_end && i < light_end && emitter_nearness(lights[min(i, light_end - 1)], point) > 0.0;
        found = near ? i : found;
        ++i;
    } while (found == light_end && i < light_end);
    return found;
}
#endif

// Angle between unit vectors over its sine over 2 pi (Hill and Heitz 2016), along their cross product.
vec3 edge_flow(vec3 a, vec3 b) {
    float x = dot(a, b);
    float y = abs(x);
    float v = (0.8543985 + (0.4965155 + 0.0145206 * y) * y) / (3.4175940 + (4.1616724 + y) * y);
    return cross(a, b) * (x > 0.0 ? v : 0.5 * inversesqrt(max(1.0 - x * x, 1e-7)) - v);
}

vec3 unit_or_zero(vec3 v) { return v * inversesqrt(max(dot(v, v), 1e-36)); }

// Of a triangle of 1 nit with the corners middle + a, + b and - a - b: its light as a vector over pi; what is below `slack` above the
// surface is left out. `wanted`: else anything, the sooner.
vec3 triangle_flow(vec3 middle, vec3 a, vec3 b, vec3 normal, float slack, bool two_sided, bool wanted) {
    float ahead = -dot(cross(a, b), middle);
    float side = ahead > 0.0 ? 1.0 : two_sided ? -1.0 : 0.0;
    vec3 from = middle + a, to = middle + b, last = middle - a - b;
    vec3 sum = vec3(0.0), setting = vec3(0.0), rising = vec3(0.0);
    int edge = 0;
    do {  // its edges, as far as they are above the horizon
        float h0 = dot(normal, from) - slack, h1 = dot(normal, to) - slack;
        bool up0 = h0 > 0.0, up1 = h1 > 0.0;
        vec3 between = unit_or_zero(mix(from, to, up0 != up1 ? h0 / (h0 - h1) : 0.0));
        setting = up0 && !up1 ? between : setting;
        rising = !up0 && up1 ? between : rising;
        sum += up0 || up1 ? edge_flow(up0 ? unit_or_zero(from) : between, up1 ? unit_or_zero(to) : between) : vec3(0.0);
        vec3 next = edge == 0 ? last : middle + a;
        from = to;
        to = next;
    } while (++edge < 3 && wanted);
    sum += edge_flow(setting, rising);
    return sum * -side;
}

// The same of parts far away.
vec3 disc_flow(vec3 d, vec3 facing, bool two_sided) {
    float r2 = max(dot(d, d), 1e-30);
    float ahead = -dot(facing, d);
    return d * ((two_sided ? abs(ahead) : max(ahead, 0.0)) / (3.14159265359 * r2 * r2));
}

// Light of the sample's parts on a surface at `point`, of unit normals; no light comes from behind the geometric one.
NearLight near_light(LightData light, float nearness, vec3 point, vec3 geometric, vec3 shading) {
    NearLight sum = NearLight(vec3(0.0), vec3(0.0));
    bool two_sided = light.two_sided != 0u;
    int end = int(light.cone_offset);
    int node = nearness > 0.0 ? int(light.cone_scale) : end;
    float rounding = 1e-6 * length(point);
    do {
        // On to the next triangle that is near; what may be taken for a disc on the way is added up.
        bool met = false;
        vec4 middle = vec4(0.0), a = vec4(0.0), b = vec4(0.0);
        vec3 nits = vec3(0.0);
        do {
            bool going = node < end && !met;
            int at = kEmitterNodeTexels * max(min(node, end - 1), 0);
            vec4 middle_here = texelFetch(emitter_nodes, at);
            vec4 a_here = texelFetch(emitter_nodes, at + 1);
            vec4 b_here = texelFetch(emitter_nodes, at + 2);
            vec3 nits_here = texelFetch(emitter_nodes, at + 3).rgb;
            int past = int(a_here.w);
            vec3 d = middle_here.xyz - point;
            float r2 = dot(d, d);
            vec3 facing = 1.5 * cross(a_here.xyz, b_here.xyz);
            float cosine = abs(dot(facing, d)) * inversesqrt(max(r2 * dot(facing, facing), 1e-30));
            bool near = r2 < kEmitterNear * kEmitterNear * middle_here.w * middle_here.w;
            bool alike = cosine > b_here.w || b_here.w < kEmitterSpread;
            bool last = past == node + 1;
            bool whole = last || (!near && alike);
            vec3 flow = disc_flow(d, facing, two_sided);
            flow = going && whole && !near && dot(flow, geometric) > 0.0 ? flow : vec3(0.0);
            sum.irradiance += nits_here * max(dot(flow, shading), 0.0);
            sum.flow += flow;
            bool meets = going && last && near;
            middle = meets ? middle_here : middle;
            a = meets ? a_here : a;
            b = meets ? b_here : b;
            nits = meets ? nits_here : nits;
            met = met || meets;
            node = !going ? node : whole ? past : node + 1;
        } while (node < end && !met);
        vec3 flow = triangle_flow(middle.xyz - point, a.xyz, b.xyz, geometric, 1e-3 * middle.w + rounding, two_sided, met);
        flow = met ? flow : vec3(0.0);
        sum.irradiance += met ? nits * max(dot(flow, shading), 0.0) : vec3(0.0);
        sum.flow += flow;
    } while (node < end);
    sum.irradiance *= 3.14159265359;
    return sum;
}

#endif
