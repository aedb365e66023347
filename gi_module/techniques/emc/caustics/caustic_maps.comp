#version 450 core
// Caustic photons through maps, where there are no exact rays (Yao et al. 2010, sec. 7): what stands in their way and where they land is
// seen in the environment maps; glass is seen in a map of its own from the middle of its box (the distance impostor of Szirmay-Kalos et
// al. 2005), which shows where light enters it and leaves it, with smooth normals.
layout(local_size_x = 64) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "gi_module/techniques/emc/photons/photon.glsl"
#include "engine/render/random.glsl"
#include "gi_module/techniques/emc/photons/scatter.glsl"
#include "engine/render/ggx.glsl"
#define BAD_VALUES_BINDING 5
#include "gi_module/shared/bad_values.glsl"

// caustic_photon.h
struct CausticPhoton {
    vec3 origin;
    uint target;
    vec3 direction;
    uint key;
    vec3 power;
    uint number;
    float range;
    float unused_x, unused_y, unused_z;
};
struct Target {
    vec4 lower;  // xyz; w = slot of its own map, -1: none
    vec4 upper;  // xyz
};

layout(std430, binding = 0) readonly buffer Photons { CausticPhoton photons[]; };
layout(std430, binding = 1) writeonly buffer Hits { PhotonHit hits[]; };  // radius 1: landed, 0: nowhere
layout(std430, binding = 2) readonly buffer Targets { Target targets[]; };

uniform int photon_count;
uniform int target_count;
uniform uint seed;

const int kSurfaces = 10;            // on the way of a photon, as caustic_chains.cpp has it
const float kRoughestMirror = 0.4;   // diffuse_reflectance.h
const float kSmallestAlpha = 2e-3;

struct Flight {
    vec3 x;
    vec3 d;
    vec3 power;
    int glass;   // target that it is within, or -1
};

float box_slack() { return 2e-3 * local_length; }

bool within(Target t, vec3 x) {
    return all(greaterThan(x, t.lower.xyz - box_slack())) && all(lessThan(x, t.upper.xyz + box_slack()));
}

// Where a ray is in a target's box; x > y: nowhere.
vec2 box_span(Target t, vec3 x, vec3 d) {
    vec3 inverse = 1.0 / mix(d, vec3(1e-20), lessThan(abs(d), vec3(1e-20)));
    vec3 a = (t.lower.xyz - box_slack() - x) * inverse;
    vec3 b = (t.upper.xyz + box_slack() - x) * inverse;
    vec3 near = min(a, b);
    vec3 far = max(a, b);
    return vec2(max(max(near.x, near.y), max(near.z, 0.0)), min(far.x, min(far.y, far.z)));
}

// What a target's own map says of a place on its surface: material + 1, and the smooth normal, outwards.
uint own_surface(int slot, vec3 x, out vec3 n) {
    vec4 kept = texelFetch(environment_albedo, map_texel(slot, x - map_centres[slot].xyz), 0);
    n = normalize(kept.xyz + vec3(0.0, 0.0, 1e-20));
    return uint(kept.w);
}

// Where light enters a target that has a map of its own; < 0: nowhere. The ray is asked from its far end: from within, where the map looks
// from, what is left behind comes first. Shapes that a ray enters twice are entered last.
float entry(int target, vec3 x, vec3 d) {
    Target t = targets[target];
    vec2 span = box_span(t, x, d);
    if (t.lower.w < 0.0 || span.x >= span.y) return -1.0;
    MapHit hit = march(int(t.lower.w), x + d * span.y, -d, 0.0, span.y - span.x);
    return hit.t >= 0.0 ? span.y - hit.t : -1.0;
}

float fifth(float x) { return x * x * x * x * x; }

float schlick(float f0, float cosine) { return f0 + (min(50.0 * f0, 1.0) - f0) * fifth(1.0 - clamp(cosine, 0.0, 1.0)); }

// On from a mirror or glass with unit normal n on the side that light comes from (dielectric.h, caustic_chains.cpp). False: it ends.
bool pass(MaterialData m, vec3 n, bool front, int target, vec4 u, inout Flight f) {
    vec3 v = -f.d;
    float alpha = max(m.roughness * m.roughness, kSmallestAlpha);
    bool smooth_one = m.roughness * m.roughness <= kSmallestAlpha;
    vec3 h = smooth_one ? n : visible_normal(n, v, alpha, u.xy);
    float vh = clamp(dot(v, h), 0.0, 1.0);
    float eta = front ? m.ior : 1.0 / m.ior;
    bool volume = m.volume.w > 0.0;
    float plain = (m.ior - 1.0) / (m.ior + 1.0);
    float strength = m.specular_colour.a * min(dot(m.specular_colour.rgb, vec3(0.2126, 0.7152, 0.0722)), 1.0);
    float beyond2 = (eta * eta - 1.0 + vh * vh) / (eta * eta);
    float beyond = sqrt(max(beyond2, 0.0));
    float parallel = (eta * vh - beyond) / max(eta * vh + beyond, 1e-20);
    float square = (vh - eta * beyond) / max(vh + eta * beyond, 1e-20);
    float reflected = eta == 1.0 ? 0.0 : 0.5 * (parallel * parallel + square * square) * strength;
    float dielectric = !volume ? schlick(plain * plain * strength, vh) : beyond2 > 0.0 ? min(reflected, 1.0) : 1.0;
    float metallic = m.roughness < kRoughestMirror ? m.metallic : 0.0;
    vec3 base = m.base_colour.rgb;
    float glass = (1.0 - m.metallic) * (m.transmission > 0.0 ? 1.0 : 0.0);
    vec3 mirrored = mix(base, vec3(1.0), fifth(1.0 - vh)) * metallic + vec3(dielectric * glass);
    vec3 passing = base * ((1.0 - m.metallic) * m.transmission * (1.0 - dielectric));
    float r = max(mirrored.x, max(mirrored.y, mirrored.z));
    float t = max(passing.x, max(passing.y, passing.z));
    float scale = 1.0 / max(r + t, 1.0);
    bool through = u.z >= r * scale;
    if (u.z >= (r + t) * scale) return false;
    vec3 l = h * (2.0 * vh) - v;
    if (through) {
        if (volume) l = h * (vh / eta - beyond) - v / eta;
        else l = smooth_one ? -v : l - n * (2.0 * dot(n, l));
    }
    f.power *= through ? passing / (t * scale) : mirrored / (r * scale);
    float nl = through ? -dot(n, l) : dot(n, l);
    if (!(nl > 0.0)) return false;
    if (!smooth_one) {
        float nv = max(dot(n, v), 1e-4);
        float a2 = alpha * alpha;
        float dv = sqrt(a2 + (1.0 - a2) * nv * nv);
        float dl = sqrt(a2 + (1.0 - a2) * nl * nl);
        f.power *= nl * (nv + dv) / max(nl * dv + nv * dl, 1e-20);
    }
    f.d = normalize(l);
    f.x += n * ((through ? -4.0 : 4.0) * origin_offset());
    f.glass = through == front ? target : -1;
    return true;
}

bool goes_on(MaterialData m) {
    return m.transmission * (1.0 - m.metallic) > 0.0 || (m.metallic > 0.5 && m.roughness < kRoughestMirror);
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= photon_count) return;
    CausticPhoton photon = photons[i];
    Flight f = Flight(photon.origin, photon.direction, photon.power, -1);
    PhotonHit stored = PhotonHit(vec3(0.0), 0.0, vec3(0.0), 0u);
    for (int s = 0; s < kSurfaces; ++s) {
        vec4 u = random4(seed ^ photon.key, photon.number, uint(s), 41u);
        int target = f.glass;
        vec3 n;
        uint number = 0u;
        float far = 0.0;
        if (f.glass >= 0) {
            int slot = int(targets[f.glass].lower.w);
            MapHit hit = march(slot, f.x, f.d, origin_offset(), length(targets[f.glass].upper.xyz - targets[f.glass].lower.xyz) + 2.0 * box_slack());
            if (hit.t < 0.0) break;
            far = hit.t;
            f.x += f.d * hit.t;
            number = own_surface(slot, f.x, n);
            if (number == 0u) break;
            f.power *= exp(-kept_materials[number - 1u].volume.rgb * hit.t);
        } else {
            SceneHit met = intersect_all(f.x, vec3(0.0), f.d, s == 0 ? 0.0 : ray_start(), 0, u.w);
            // The nearest glass on the way; its own front, if a map shows it, is the same surface.
            float nearest = met.found ? met.t : 1e30;
            int glass = -1;
            for (int k = 0; k < target_count; ++k) {
                float t = entry(k, f.x, f.d);
                bool own = glass < 0 && within(targets[k], met.position);
                if (t > 4.0 * origin_offset() && (t < nearest || (own && met.found && t < nearest + 0.02 * local_length))) {
                    nearest = t;
                    glass = k;
                }
            }
            if (glass >= 0) {
                target = glass;
                f.x += f.d * nearest;
                number = own_surface(int(targets[glass].lower.w), f.x, n);
            } else if (met.found) {
                f.x = met.position;
                n = met.normal;
                number = uint(met.kept.w);
                // Maps know no instances: where boxes of targets overlap, each gets its share.
                int boxes = 0;
                for (int k = 0; k < target_count && s == 0; ++k) {
                    bool inside = within(targets[k], f.x);
                    boxes += inside ? 1 : 0;
                    if (inside && k == int(photon.target)) target = k;
                }
                f.power /= float(max(boxes, 1));
            } else {
                break;
            }
            far = nearest;
            bool on = number > 0u && goes_on(kept_materials[number - 1u]);
            if (s == 0) {
                // What it meets first is to be its own target.
                if (!on || target != int(photon.target)) break;
                float share = far / photon.range;
                f.power *= clamp(1.0 - share * share * share * share, 0.0, 1.0);
            } else if (!on) {
                stored = PhotonHit(f.x, 1.0, f.power, pack_normal(n));
                break;
            }
            if (number == 0u) break;
        }
        bool front = f.glass < 0;
        n = dot(n, f.d) > 0.0 ? -n : n;
        if (!pass(kept_materials[number - 1u], n, front, target, u, f)) break;
    }
    if (is_bad(stored.power) || is_bad(stored.position)) {
        atomicAdd(bad_value_count, 1u);
        stored.radius = 0.0;
    }
    hits[i] = stored;
}
