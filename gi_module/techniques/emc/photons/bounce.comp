#version 450 core
// One bounce: intersect, store the arrival, scatter (Yao et al. 2010, sec. 3 and 5; bandwidth of sec. 6).
// ONE_MAP 1: each photon asks one map; those that it cannot settle are listed for the next dispatch. ONE_MAP 0: each asks every
// map. `listed` says whether the photons are those of a list, or all. DIRECTIONS 1: from where they have come is kept,
// for glossy surfaces.
layout(local_size_x = 64) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "engine/gpu/work_items.glsl"
#include "photon.glsl"
#include "engine/render/random.glsl"
#include "scatter.glsl"
#include "surface_bsdf.glsl"
#define BAD_VALUES_BINDING 5
#include "gi_module/shared/bad_values.glsl"

layout(std430, binding = 0) buffer Rays { PhotonRay rays[]; };
layout(std430, binding = 1) writeonly buffer Hits { PhotonHit hits[]; };
#if DIRECTIONS
layout(std430, binding = 8) writeonly buffer Directions { uint directions[]; };  // PhotonSet::directions
#endif
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };
layout(std430, binding = 7) buffer Unsettled { uint unsettled_count; uint unsettled_groups[3]; uint unsettled[]; };

uniform int photon_count;
uniform int listed;
uniform int bounce;           // 1-based: reflections so far
uniform uint seed;
uniform float bandwidth;      // C0 * sqrt(A / N), metres
uniform int bandwidth_fixed;  // 1: h = bandwidth everywhere
uniform vec2 pdf_range;       // clamp of the dimensionless p
uniform float total_area;     // A, m^2

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= photon_count) return;
    if (listed != 0) {
        if (i >= int(listed_count)) return;
        i = int(list[i]);
    }
    PhotonRay ray = rays[i];
    PhotonHit stored;
    stored.position = vec3(0.0);
    stored.radius = 0.0;
    stored.power = vec3(0.0);
    stored.normal = 0u;
#if DIRECTIONS
    directions[(bounce - 1) * photon_count + i] = pack_normal(ray.direction.xyz);
#endif
    if (ray.direction.w > 0.0) {
        vec4 u = scatter_numbers(seed, ray.number, uint(bounce));
        int hint = first_map(ray.start);
        vec3 n = start_normal(ray.start);
#if ONE_MAP
        bool settled;
        SceneHit hit = intersect_next(ray.origin, n, ray.direction.xyz, ray_start(), hint, listed == 0, u.w, settled);
        if (!settled) {
            rays[i].start = start_bits(hint, n);
            uint place;
            TAKE_PLACES(unsettled_count, 1u, place)
            unsettled[place] = uint(i);
            if ((place & 63u) == 0u) atomicAdd(unsettled_groups[0], 1u);
            return;
        }
#else
        SceneHit hit = intersect_all(ray.origin, n, ray.direction.xyz, ray_start(), hint, u.w);
#endif
        if (hit.found) {
            stored.position = hit.position;
            stored.power = ray.power;
            stored.normal = pack_normal(hit.normal);
            // p = cos / d^2 (sec. 6), made dimensionless by the mean density pi / A, so that p = 1 is the average photon
            // times that of the direction, where a lobe has scattered it.
            float p = ray.direction.w * max(dot(hit.normal, -ray.direction.xyz), 0.0) / max(hit.t * hit.t, 1e-12 * total_area);
            p = clamp(p * total_area / 3.14159265, pdf_range.x, pdf_range.y);
            stored.radius = bandwidth_fixed != 0 ? bandwidth : bandwidth * inversesqrt(p);
            Scattered on = scatter_kept(kept_surface(hit.kept), hit.normal, -ray.direction.xyz, u.xyz);
            ray.power *= on.weight;
            ray.origin = hit.position + hit.normal * origin_offset();
            ray.start = start_bits(hit.slot, hit.normal);
            ray.direction = vec4(on.direction, on.density);
        } else {
            ray.direction.w = 0.0;
        }
        if (is_bad(ray.power)) {
            atomicAdd(bad_value_count, 1u);
            ray.power = vec3(0.0);
            ray.direction.w = 0.0;
        }
        rays[i] = ray;
    }
    hits[(bounce - 1) * photon_count + i] = stored;
}
