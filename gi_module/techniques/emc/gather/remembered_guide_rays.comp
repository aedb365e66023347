#version 450 core
// Guides the rays of the listed starts: directions by where light came from at their tile, and the weights that make up for that.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "ray_numbers.glsl"
#include "remembered_guide.glsl"

layout(std430, binding = 4) writeonly buffer Texels { uint texels[]; };
layout(std430, binding = 5) writeonly buffer Flights { uvec2 flights[]; };
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform samplerBuffer starts;
uniform samplerBuffer guide;  // by cell of a tile: root mean square of what rays met, of the tile's mean

// Cells of the cosine lobe's unit square.
const int kRings = 8;
const int kSectors = 8;
const int kLobeCells = kRings * kSectors;
const float kLeastDensity = 0.25;  // of a cosine lobe's: no ray counts as more than four

float density[kLobeCells];   // of a cosine lobe's: ring by ring in each sector
float of_sectors[kSectors];  // their sums

void make_density(uint tile, vec3 n) {
    vec3 t;
    vec3 bt;
    basis_around(n, t, bt);
    float sum = 0.0;
    // Through the cells' middles: cosine_direction(), but for what all cells of a sector share.
    for (int s = 0; s < kSectors; ++s) {
        float phi = 6.28318530718 * (float(s) + 0.5) / float(kSectors);
        vec3 side = t * cos(phi) + bt * sin(phi);
        for (int r = 0; r < kRings; ++r) {
            float u = (float(r) + 0.5) / float(kRings);
            float rms = texelFetch(guide, int(guide_cell(tile, side * sqrt(u) + n * sqrt(1.0 - u)))).r;
            density[s * kRings + r] = rms;
            sum += rms;
        }
    }
    float f = (1.0 - kLeastDensity) * float(kLobeCells) / sum;
    for (int s = 0; s < kSectors; ++s) {
        of_sectors[s] = 0.0;
        for (int r = 0; r < kRings; ++r) {
            int k = s * kRings + r;
            density[k] = kLeastDensity + f * density[k];
            of_sectors[s] += density[k];
        }
    }
}

// Spreads numbers that are even by the density, which it gives, where they come to lie: first the sector, then the ring.
float spread(inout vec2 u) {
    float left = u.y * float(kLobeCells);
    int sector = 0;
    while (sector < kSectors - 1 && left >= of_sectors[sector]) left -= of_sectors[sector++];
    float v = (float(sector) + min(left / of_sectors[sector], 0.99999)) / float(kSectors);
    left = u.x * of_sectors[sector];
    int first = sector * kRings;
    int ring = 0;
    while (ring < kRings - 1 && left >= density[first + ring]) left -= density[first + ring++];
    float of_cell = density[first + ring];
    u = vec2((float(ring) + min(left / of_cell, 0.99999)) / float(kRings), v);
    return of_cell;
}

// One of the two codes nearest to a weight, by chance, so that the mean is the weight.
uint weight_code(float w, float u) {
    uint low = clamp(uint(sqrt(w * kWeightUnits)), 1u, 126u);
    float a = weight_of(low);
    float b = weight_of(low + 1u);
    return w - a > u * (b - a) ? low + 1u : low;
}

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
    uint at = list[item];
    uint slot = at / uint(capacity);
    uint key = at % uint(capacity);
    vec3 n = point_normal(texelFetch(starts, int(at)));
    make_density(guide_tile(key, uint(row)), n);
    for (uint j = 0u; j < uint(rays); ++j) {
        uint entry = entry_of(slot, j, key);
        vec2 u = ray_numbers(key, slot, j);
        float w = 1.0 / spread(u);
        uint code = weight_code(w, random4(seed, key, slot, 53u + j).x);
        flights[entry] = uvec2(pack_direction(cosine_direction(n, u)), 0u);
        texels[entry] = code << kWeightShift | kUnknown;
    }
}
