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
uniform int mips;          // DrmMips: 0 all is a mean, 1 light alone, 2 nothing, 3 radiance alone
uniform int solid_angle;   // SolidAngle: 0 eq. 14, 1 disc, 2 eq. 15, 3 eq. 11, 4 eq. 13
uniform float diagonal2;   // of the scene's box, squared
uniform int has_mirrored;  // there are ends
uniform uint first;        // the sample that is written first
uniform int has_place;     // the place of a sample is looked for

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

Cell middle_cell(uint p, uvec2 cell, Sums sums, int texels) {
    bool on;
    PictureRay ray = picture_ray(pictures[p], lights[p], (vec2(cell) + 0.5) / float(side));
    Seen s = look_along(p, ray, 1.0 / float(side * side), on);
    if (s.area <= 0.0) return kEmptyCell;
    vec3 flux = mips == 1 ? sums.a.rgb : mips == 3 ? sums.e * (s.area / float(texels)) : s.flux;
    float as_asked = solid_angle == 2 ? s.across / s.area : solid_angle == 3 ? 1.0 / s.area : 1.0;
    return Cell(s.offset, s.normal, s.area, s.across, flux * as_asked);
}

// The place of the cell's lit surface that is nearest to its mean, on the same side; all invocations take part.
vec3 nearest_place(uint p, uvec2 cell, uint lane, Cell mean) {
    if (lane == 0u) {
        sums_d[0] = mean.offset;
        sums_e[0] = mean.normal;
    }
    barrier();
    vec3 offset = sums_d[0], normal = sums_e[0];
    vec4 nearest = vec4(offset, 3e38);
    int width = side * cell_texels;
    bool on;
    for (int i = int(lane); i < cell_texels * cell_texels; i += 64) {
        ivec2 at = ivec2(cell) * cell_texels + ivec2(i % cell_texels, i / cell_texels);
        PictureRay ray = picture_ray(pictures[p], lights[p], (vec2(at) + 0.5) / float(width));
        Seen s = look_along(p, ray, 1.0, on);
        vec3 way = s.offset - offset;
        if (s.area > 0.0 && dot(s.normal, normal) > 0.3 && dot(way, way) < nearest.w) nearest = vec4(s.offset, dot(way, way));
    }
    sums_a[lane] = nearest;
    barrier();
    for (int i = 0; lane == 0u && i < 64; ++i) {
        if (sums_a[i].w < nearest.w) nearest = sums_a[i];
    }
    return nearest.xyz;
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
    return middle_cell(p, cell, sums, n);
}

RadianceSample no_sample(uint p) {
    return RadianceSample(lights[p].position, 1.0, vec3(0.0), 0.0, vec3(0.0), -1, lights[p].position, 0.0);
}

void main() {
    uint lane = gl_LocalInvocationID.x;
    uint cells = uint(side * side);
    uint p = gl_WorkGroupID.y;
    uint cell = gl_WorkGroupID.x;
    uint at = first + p * cells + cell;
    uvec2 place = uvec2(cell % uint(side), cell / uint(side));
    Cell c = whole_cell(p, place, lane);
    vec3 looks_from = c.offset;
    if (has_place != 0 && mips == 0) {
        barrier();
        looks_from = nearest_place(p, place, lane, c);
    }
    if (lane != 0u) return;
    RadianceSample result = no_sample(p);
    if (c.area > 0.0) {
        result.place = result.position + looks_from;
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
        result = no_sample(p);
    }
    samples[at] = result;
}
