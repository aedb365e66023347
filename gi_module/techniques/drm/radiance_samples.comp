#version 450 core
// The samples of the direct radiance maps (Frisvad et al. 2005, sec. 4 and 5): M x M of each light's picture. One work group a
// sample, whose invocations look at the texels of its cell; the mean over them is the mip level whose texels are as large as cells.
layout(local_size_x = 64) in;

#include "picture_look.glsl"
#include "gi_module/shared/mirrors/specular.glsl"
#define BAD_VALUES_BINDING 5
#include "gi_module/shared/bad_values.glsl"

layout(std430, binding = kSamplesBinding) writeonly buffer Samples { RadianceSample samples[]; };
// Where light that mirrors send on arrives: by texel the first end's index + 1, 0 for none.
layout(std430, binding = 6) readonly buffer FirstEnds { uint first_ends[]; };
layout(std430, binding = 7) readonly buffer Ends { SpecularHit ends[]; };

uniform int side;          // M
uniform int cell_texels;   // a side of a sample's cell
uniform int mips;          // DrmMips: 0 all is a mean, 1 light alone, 2 nothing
uniform int solid_angle;   // SolidAngle: 0 eq. 14, 1 disc, 2 eq. 15, 3 eq. 11
uniform float diagonal2;   // of the scene's box, squared
uniform int has_mirrored;  // there are ends

shared vec4 sums_a[64];
shared vec4 sums_b[64];
shared vec4 sums_c[64];
shared vec3 sums_d[64];
shared vec3 sums_e[64];

struct Sums {
    vec4 a;  // flux; across
    vec4 b;  // offset by flux; flux of all colours
    vec4 c;  // normal by flux; flux squared over area
    vec3 d;  // flux times across over area
    vec3 e;  // flux over area
};

void add(inout Sums sums, Seen s) {
    float weight = s.flux.r + s.flux.g + s.flux.b;
    sums.a += vec4(s.flux, s.across);
    sums.b += vec4(s.offset, 1.0) * weight;
    sums.c += vec4(s.normal * weight, weight * weight / s.area);
    sums.d += s.flux * (s.across / s.area);
    sums.e += s.flux / s.area;
}

// Light that mirrors send on (light paths L S* D D): as wide as it would be if they were flat.
void add_mirrored(inout Sums sums, uint p, uint texel, PictureRay ray, Seen met, float share) {
    uint next = first_ends[texel];
    while (next != 0u) {
        SpecularHit end = ends[next - 1u];
        next = end.next == 0u ? 0u : end.next + 1u;
        if (end.kind != kMetSurface) continue;
        Seen s = met;
        vec3 mirror = lights[p].position + met.offset;
        s.offset = end.position - lights[p].position;
        s.normal = end.normal;
        s.along += distance(end.position, mirror);
        s.across = ray.extent * share * (pictures[p].shape == kPictureParallel ? 1.0 : s.along * s.along);
        s.area = drm_area(s.across, dot(end.normal, normalize(mirror - end.position)));
        s.flux = ray.lumen * end.reflectance * (share * light_range_window(lights[p], s.along));
        add(sums, s);
    }
}

// What a cell covers and sends, in the mean of its texels or by the one in its middle, as the solid angle asks for it.
struct Cell {
    vec3 offset;
    vec3 normal;
    float area;
    float across;
    vec3 sent;  // lumen; eq. 15: times A' / A, eq. 11: over A
};

const Cell kEmptyCell = Cell(vec3(0.0), vec3(0.0), 0.0, 0.0, vec3(0.0));

// Its area is that over which its light lies: the mean of radiance, by light, tells. Where parts graze, the sum of areas is theirs.
Cell mean_cell(Sums sums, int texels) {
    if (isinf(sums.b.w * sums.b.w) || isinf(sums.c.w)) return Cell(vec3(0.0), vec3(0.0), uintBitsToFloat(0x7fc00000u), 0.0, vec3(0.0));
    if (!(sums.b.w > 0.0) || !(sums.c.w > 0.0) || dot(sums.c.xyz, sums.c.xyz) == 0.0) return kEmptyCell;
    Cell cell = Cell(sums.b.xyz / sums.b.w, normalize(sums.c.xyz), sums.b.w * sums.b.w / sums.c.w, sums.a.w, sums.a.rgb);
    if (solid_angle == 2) cell.sent = sums.d;
    if (solid_angle == 3) cell.sent = sums.e / float(texels);
    return cell;
}

Cell middle_cell(uint p, uvec2 cell, vec3 flux_of_all) {
    bool on;
    PictureRay ray = picture_ray(pictures[p], lights[p], (vec2(cell) + 0.5) / float(side));
    Seen s = look_along(p, ray, 1.0 / float(side * side), on);
    if (s.area <= 0.0) return kEmptyCell;
    vec3 flux = mips == 1 ? flux_of_all : s.flux;
    float as_asked = solid_angle == 2 ? s.across / s.area : solid_angle == 3 ? 1.0 / s.area : 1.0;
    return Cell(s.offset, s.normal, s.area, s.across, flux * as_asked);
}

Cell whole_cell(uint p, uvec2 cell, uint lane) {
    int n = mips == 2 ? 0 : cell_texels * cell_texels;
    int width = side * cell_texels;
    float share = 1.0 / float(width * width);
    Sums sums = Sums(vec4(0.0), vec4(0.0), vec4(0.0), vec3(0.0), vec3(0.0));
    bool on;
    for (int i = int(lane); i < n; i += 64) {
        ivec2 at = ivec2(cell) * cell_texels + ivec2(i % cell_texels, i / cell_texels);
        PictureRay ray = picture_ray(pictures[p], lights[p], (vec2(at) + 0.5) / float(width));
        Seen s = look_along(p, ray, share, on);
        if (s.area <= 0.0) continue;
        add(sums, s);
        if (on && has_mirrored != 0) add_mirrored(sums, p, p * uint(width * width) + uint(at.y * width + at.x), ray, s, share);
    }
    sums_a[lane] = sums.a;
    sums_b[lane] = sums.b;
    sums_c[lane] = sums.c;
    sums_d[lane] = sums.d;
    sums_e[lane] = sums.e;
    barrier();
    if (lane != 0u) return kEmptyCell;
    for (int i = 1; i < 64; ++i) {
        sums.a += sums_a[i];
        sums.b += sums_b[i];
        sums.c += sums_c[i];
        sums.d += sums_d[i];
        sums.e += sums_e[i];
    }
    if (mips == 0) return mean_cell(sums, n);
    return middle_cell(p, cell, sums.a.rgb);
}

void main() {
    uint lane = gl_LocalInvocationID.x;
    uint cells = uint(side * side);
    uint p = gl_WorkGroupID.y;
    uint cell = gl_WorkGroupID.x;
    uint at = p * cells + cell;
    Cell c = whole_cell(p, uvec2(cell % uint(side), cell / uint(side)), lane);
    if (lane != 0u) return;
    RadianceSample result = RadianceSample(lights[p].position, 1.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    if (c.area > 0.0) {
        result.position += c.offset;
        result.normal = c.normal;
        result.area = solid_angle == 1 ? c.area * 0.31830988618 : c.area;
        result.across = c.across;
        result.sent = c.sent * 0.31830988618;
        if (solid_angle == 2) result.sent = drm_sent_15(result.sent, diagonal2);
        if (solid_angle == 3) result.sent *= drm_solid_angle_11(float(cells));
    }
    bool lost = isnan(c.area) || isinf(c.area);
    if (lost || is_bad(result.sent) || is_bad(result.position) || is_bad(result.normal)) {
        atomicAdd(bad_value_count, 1u);
        result = RadianceSample(lights[p].position, 1.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    }
    samples[at] = result;
}
