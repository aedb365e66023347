#version 450 core
// What the texels of the listed blocks see, and whether they are to be lit: of each surface those of the map that sees it
// sharpest; of a reserved map, where no other sees it.
layout(local_size_x = 256) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "lit_square.glsl"

// By place.
layout(std430, binding = 1) writeonly buffer Points { vec4 points[]; };
layout(std430, binding = 2) writeonly buffer Albedo { vec4 albedo[]; };
layout(std430, binding = 3) buffer Changed { uint changed[]; };        // a bit each, and one a block from `changed_blocks` on
layout(std430, binding = 4) buffer Radiosity { vec4 radiosity[]; };    // a < 0: not lit
layout(std430, binding = 5) writeonly buffer First { vec4 first[]; };  // the same
layout(std430, binding = 0) buffer Sharper { uint sharper[]; };  // by block, two words: bits of the maps that its texels must ask
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

const float kSharper = 1.25;  // a map lights no texel that another shows so much sharper

uniform uint changed_blocks;   // word of `changed`
uniform bool mark_changed;     // blocks in which something has
uniform ivec2 reserved_slots;  // of maps that light only what no other shows; -1: none

bool is_reserved(int slot) { return slot == reserved_slots.x || slot == reserved_slots.y; }

// What stands on the surface of normal n at `o` around the lit texel p, as it was drawn: of parallel ones the nearest, of others two.
uvec4 sheets_on(ivec3 p, vec3 o, vec3 n) {
    uvec4 sheets = uvec4(0u);
    float around = 0.5 / float(lit_resolution) + kSideTexels / float(map_resolution);
    vec2 middle = (vec2(p.xy) + 0.5) / float(lit_resolution);
    for (int k = 0; k < 9; ++k) {
        ivec3 texel = map_texel(p.z / 6, cube_direction(p.z % 6, middle + around * (vec2(k % 3, k / 3) - 1.0)));
        uvec2 kept = texelFetch(environment_planes, texel, 0).rg;
        vec3 g = plane_of(kept);
        vec3 first = plane_of(sheets.xy);
        bool stands = g != vec3(0.0) && dot(o, g) < 1.0 + kSideSlack && stands_on(texel, g, o, n);
        bool as_first = dot(g, first) > kLeastLitCosine * length(g) * length(first);
        bool nearer = dot(o, g) > dot(o, as_first ? first : plane_of(sheets.zw));
        if (stands && nearer) sheets = first == vec3(0.0) || as_first ? uvec4(kept, sheets.zw) : uvec4(sheets.xy, kept);
    }
    return sheets;
}

void main() {
    uint item = work_item();
    if (item >= listed_count * kBlockTexels) return;
    uint block = list[item / kBlockTexels];
    ivec3 p = texel_of_block(int(block), int(item % kBlockTexels));
    int place = lit_place(p);
    int slot = p.z / 6;
    LitSquare square = square_of(p);
    vec3 o = square.o;
    vec3 n = square.n;
    bool shows_something = slot_in_use(slot, 0.0) && square.shows;
    vec3 x = map_centres[slot].xyz + o;
    float least = kSharper * sharpness(o, n);
    bool last = is_reserved(slot);
    uvec2 to_ask = uvec2(0u);
    for (int s = 0; s < MAPS; ++s) {
        float w = sharpness(x - map_centres[s].xyz, n);
        bool goes_first = is_reserved(s) ? last && w > least : w > (last ? 0.0 : least);
        bool ask = shows_something && s != slot && slot_in_use(s, 0.0) && goes_first;
        to_ask[s >> 5] |= ask ? 1u << (s & 31) : 0u;
    }
    for (int k = 0; k < (MAPS + 31) / 32; ++k) {
        if (to_ask[k] != 0u) atomicOr(sharper[2u * block + uint(k)], to_ask[k]);
    }
    bool sharpest = shows_something;
    while (sharpest && (to_ask.x | to_ask.y) != 0u) {
        int s = take_first(to_ask);
        vec3 from = x - map_centres[s].xyz;
        sharpest = !(on_plane(from, n, plane_at(lit_middle(lit_texel(s, from)))) && !sheet_hides(s, from, n));
    }
    vec4 before = texelFetch(lit_points, place);
    vec4 now = sharpest ? pack_point(x, n) : vec4(x, uintBitsToFloat(kUnlitPoint));
    uvec4 stood = floatBitsToUint(texelFetch(lit_points, lit_sheets + place));
    uvec4 stands = uvec4(0u);
    bool looks = sharpest;
    while (looks) {
        stands = sheets_on(p, o, n);
        looks = false;
    }
    bool same = is_lit(before) == sharpest && (!sharpest || (floatBitsToUint(before) == floatBitsToUint(now) && stood == stands));
    if (!same) atomicOr(changed[place >> 5], 1u << (place & 31));
    bool marks = !same && mark_changed;
    while (marks) {
        atomicOr(changed[changed_blocks + (block >> 5)], 1u << (block & 31u));
        marks = false;
    }
    // Loops, so that a vector of texels that find what was there writes nothing, and one of texels that are not lit does no more.
    bool other = floatBitsToUint(before) != floatBitsToUint(now) || stood != stands;
    while (other) {
        points[place] = now;
        points[lit_sheets + place] = uintBitsToFloat(stands);
        other = false;
    }
    bool goes_out = is_lit(before) && !sharpest;
    while (goes_out) {
        radiosity[place] = vec4(0.0, 0.0, 0.0, -1.0);
        first[place] = vec4(0.0, 0.0, 0.0, -1.0);
        goes_out = false;
    }
    while (sharpest) {
        if (radiosity[place].a < 0.0) radiosity[place] = vec4(0.0);
        albedo[place] = vec4(albedo_of(p, square), 0.0);
        sharpest = false;
    }
}
