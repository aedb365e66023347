// Rays of the sky's photons towards the scene. The C++ side: sky_photons.h. The includer says SKY_CELLS_BINDING and includes
// intersection.glsl.
#ifndef LANTHORN_EMC_SKY_PHOTONS_GLSL
#define LANTHORN_EMC_SKY_PHOTONS_GLSL

layout(std430, binding = SKY_CELLS_BINDING) readonly buffer SkyCells { vec4 sky_cells[]; };  // SkyPhotonCell

uniform int sky_cell_columns;
uniform int sky_cell_rows;
uniform mat3 sky_to_render;

// Where the scene's box is entered by a photon from the sky, the unit direction back there, and its power, in lumen times the
// number of photons. `u`: of the cell and of the place on the box; `v`: within the cell. All in 0..1.
void sky_photon(vec3 u, vec2 v, out vec3 entry, out vec3 to_sky, out vec3 power) {
    int low = 0;
    int high = sky_cell_columns * sky_cell_rows - 1;
    while (low < high) {
        int middle = (low + high) / 2;
        if (sky_cells[middle].x <= u.x) low = middle + 1;
        else high = middle;
    }
    vec4 cell = sky_cells[low];
    const float pi = 3.14159265359;
    vec2 at = vec2(low % sky_cell_columns, low / sky_cell_columns);
    float upper = cos(pi * at.y / float(sky_cell_rows));
    float lower = cos(pi * (at.y + 1.0) / float(sky_cell_rows));
    float height = mix(upper, lower, v.y);  // even by solid angle
    float longitude = ((at.x + v.x) / float(sky_cell_columns) - 0.5) * 2.0 * pi;
    float flat_length = sqrt(max(1.0 - height * height, 0.0));
    to_sky = sky_to_render * vec3(flat_length * cos(longitude), height, flat_length * sin(longitude));

    // Evenly over the box's shadow: a face by the area that is seen of it, then evenly on that.
    vec3 size = scene_upper - scene_lower;
    vec3 areas = abs(to_sky) * size.yzx * size.zxy;
    float area = areas.x + areas.y + areas.z;
    float chosen = u.y * area;
    int axis = chosen < areas.x ? 0 : chosen < areas.x + areas.y || areas.z <= 0.0 ? 1 : 2;
    float left = chosen - (axis == 0 ? 0.0 : axis == 1 ? areas.x : areas.x + areas.y);
    float rest = clamp(left / max(areas[axis], 1e-30), 0.0, 1.0);
    vec3 part = axis == 0 ? vec3(0.0, rest, u.z) : axis == 1 ? vec3(u.z, 0.0, rest) : vec3(rest, u.z, 0.0);
    entry = scene_lower + size * part;
    entry[axis] = to_sky[axis] >= 0.0 ? scene_upper[axis] : scene_lower[axis];
    power = cell.yzw * area;
}

// The first surface of such a photon: the nearest that any map sees on its way, from which a ray back finds the sky. Where
// that one finds something, the photon has met what no map sees from there.
SceneHit sky_photon_hit(vec3 entry, vec3 to_sky, float u) {
    vec3 start = entry + to_sky * (0.01 * scene_diagonal);
    SceneHit best;
    best.found = false;
    best.position = entry;
    best.normal = to_sky;
    best.albedo = vec3(0.0);
    best.kept = vec4(0.0);
    best.slot = 0;
    best.t = scene_exit(start, -to_sky);
    ivec3 texel = ivec3(0);
    for (int slot = 0; slot < map_count; ++slot) {
        if (!slot_in_use(slot, u)) continue;
        MapHit hit = march(slot, start, -to_sky, 0.0, best.t);
        if (hit.t < 0.0) continue;
        best.found = true;
        best.t = hit.t;
        best.normal = hit.normal;
        best.slot = slot;
        texel = hit.texel;
    }
    if (!best.found) return best;
    best.position = start - to_sky * best.t;
    best.kept = texelFetch(environment_albedo, texel, 0);
    best.albedo = kept_albedo(best.kept);
    SceneHit back = intersect_all(best.position + best.normal * origin_offset(), best.normal, to_sky, ray_start(), best.slot, u);
    best.found = !back.found;
    return best;
}

#endif
