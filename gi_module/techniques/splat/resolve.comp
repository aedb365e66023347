#version 450 core
// From sums of photons to irradiance (Lavignotte and Paulin 2003, eq. 7), and whether a smaller bandwidth would be better
// (their oracle, sec. 4.3). What is decided is added to the picture; tiles with pixels that are not are noted.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D sums;
uniform samplerBuffer inverse_areas;
uniform usamplerBuffer pixels;     // PixelSurface
uniform samplerBuffer bandwidths;  // by side, of this level
uniform usamplerBuffer splatted;   // by tile: 0 where this level has no photons, far from all pixels that are not decided
layout(rgba32f, binding = 0) uniform image2D irradiance;
layout(r32ui, binding = 1) uniform uimage2D decided;
layout(std430, binding = 0) buffer Open { uint open_tiles[]; };
layout(std430, binding = 1) buffer Bad { uint bad_values; };
uniform ivec2 image_size;
uniform int tiles_across;
uniform int last_level;
uniform float least;
uniform float most;
uniform float bias;

const int kFarthest = 32;  // pixels between those that are compared

struct Pixel {
    vec3 position;
    uint side;
    float count;
};

Pixel pixel_at(ivec2 p) {
    Pixel result;
    uvec4 at = texelFetch(pixels, p.y * image_size.x + p.x);
    result.position = uintBitsToFloat(at.xyz);
    result.side = at.w;
    result.count = texelFetch(sums, p, 0).a;
    return result;
}

bool in_picture(ivec2 p) { return all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, image_size)); }

// The second difference of the number of photons along an axis, on a grid that is irregular in space; pixels half a
// bandwidth apart. Forward or backward where the surface ends.
float second_difference(ivec2 p, Pixel here, ivec2 axis, float h) {
    ivec2 beside = in_picture(p + axis) && pixel_at(p + axis).side == here.side ? p + axis : p - axis;
    if (!in_picture(beside)) return 0.0;
    float spacing = length(pixel_at(beside).position - here.position);
    int stride = int(clamp(0.5 * h / max(spacing, 1e-30), 1.0, float(kFarthest)));
    Pixel line[5];
    bool there[5];
    for (int k = -2; k <= 2; ++k) {
        ivec2 q = p + k * stride * axis;
        there[k + 2] = in_picture(q);
        if (!there[k + 2]) continue;
        line[k + 2] = pixel_at(q);
        bool counted = texelFetch(splatted, (q.y / 8) * tiles_across + q.x / 8).x != 0u;
        there[k + 2] = counted && line[k + 2].side == here.side;
    }
    int middle = there[1] && there[3] ? 2 : there[3] && there[4] ? 3 : there[0] && there[1] ? 1 : -1;
    if (middle < 0) return 0.0;
    float after = max(length(line[middle + 1].position - line[middle].position), 1e-30);
    float before = max(length(line[middle].position - line[middle - 1].position), 1e-30);
    return ((line[middle + 1].count - line[middle].count) / after - (line[middle].count - line[middle - 1].count) / before) *
           0.5 * (after + before);
}

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, image_size)) || imageLoad(decided, p).x != 0u) return;
    Pixel here = pixel_at(p);
    if (here.side == 0xffffffffu) return;
    bool good = last_level != 0 || here.count < least;
    if (!good && here.count < most) {
        float h = texelFetch(bandwidths, int(here.side)).x;
        float level = max(abs(second_difference(p, here, ivec2(1, 0), h)), abs(second_difference(p, here, ivec2(0, 1), h)));
        good = level <= bias * here.count;
    }
    if (!good) {
        open_tiles[(p.y / 8) * tiles_across + p.x / 8] = 1u;
        return;
    }
    vec3 light = texelFetch(sums, p, 0).rgb * texelFetch(inverse_areas, p.y * image_size.x + p.x).x;
    if (any(isnan(light)) || any(isinf(light))) {
        atomicAdd(bad_values, 1u);
        light = vec3(0.0);
    }
    imageStore(irradiance, p, imageLoad(irradiance, p) + vec4(light, 0.0));
    imageStore(decided, p, uvec4(1u));
}
