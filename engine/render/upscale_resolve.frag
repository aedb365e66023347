#version 450 core
// A pixel of the whole picture from the drawn ones around it and, WITH_HISTORY, from what the frames before made of it; MOVING: of
// where it was then. rgb as the drawn picture has it, a: how many samples it is made of.
#include "upscale_colour.glsl"

layout(location = 0) out vec4 out_picture;

uniform sampler2D picture;   // as drawn, encoded for display
uniform sampler2D smoothed;  // the same with smooth edges
uniform vec2 shift;         // drawn pixels: how far off its middle each was looked through
uniform vec2 ratio;         // drawn pixels a pixel of the whole picture
#ifdef WITH_HISTORY
uniform sampler2D guide_mean;  // upscale_guide.frag
uniform sampler2D guide_spread;
uniform sampler2D history;  // as this picture
uniform float most_known;   // samples that the past may count for
#ifdef MOVING
uniform sampler2D guide_motion;
#endif
#endif

const float kSharp = 3.0;       // a sample d pixels of the whole picture away counts exp2(-kSharp d^2)
const float kOwn = 0.25;        // samples that the spatial guess counts for
const float kMostMoving = 4.0;  // samples that a past counts for which has been resampled
#ifdef MOVING
const float kWide = 1.0;        // standard deviations that the past may differ by (Salvi 2016)
#else
const float kWide = 2.0;        // where nothing moves it knows more than one frame's pixels do
#endif

// Between 3 x 3 drawn pixels: a kernel that is long along an edge and short across it. Direction and how sure it is come from the
// structure tensor of brightness, weighed by nearness (after the idea of FSR 1: Lottes 2021, "FidelityFX Super Resolution", EASU).
vec3 along_edges(ivec2 nearest, vec2 here) {
    ivec2 last = textureSize(picture, 0) - 1;
    vec3 c[9];
    float y[9];
    for (int k = 0; k < 9; ++k) {
        c[k] = texelFetch(smoothed, clamp(nearest + ivec2(k % 3, k / 3) - 1, ivec2(0), last), 0).rgb;
        y[k] = dot(c[k], vec3(0.25, 0.5, 0.25));
    }
    vec2 f = here - vec2(nearest);  // 0..1 in the middle one
    vec3 tensor = vec3(0.0);        // xx, xy, yy
    for (int q = 0; q < 4; ++q) {
        int i = (q & 1) + 3 * (q >> 1);
        vec2 g = vec2(y[i + 1] - y[i] + y[i + 4] - y[i + 3], y[i + 3] - y[i] + y[i + 4] - y[i + 1]);
        vec2 near = mix(1.0 - f, f, vec2(q & 1, q >> 1));
        tensor += (near.x * near.y + 0.05) * vec3(g.x * g.x, g.x * g.y, g.y * g.y);
    }
    float half_difference = 0.5 * (tensor.x - tensor.z);
    float spread = sqrt(half_difference * half_difference + tensor.y * tensor.y);
    float sure = 2.0 * spread / (tensor.x + tensor.z + 1e-5);  // 0: no direction, 1: a straight edge
    vec2 across = vec2(half_difference + spread, tensor.y);
    across = dot(across, across) > 1e-12 ? normalize(across) : (tensor.x >= tensor.z ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
    float narrow = mix(2.2, 3.2, sure);
    float wide = mix(2.2, 0.8, sure);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int k = 0; k < 9; ++k) {
        vec2 d = vec2(k % 3, k / 3) - 0.5 - f;
        float a = dot(d, across);
        float b = dot(d, vec2(-across.y, across.x));
        float w = exp2(-narrow * a * a - wide * b * b);
        sum += w * c[k];
        weights += w;
    }
    return sum / weights;
}

#ifdef WITH_HISTORY
#ifdef MOVING
// Catmull-Rom between 4 x 4 texels in five bilinear look-ups: the corners count next to nothing (Jimenez 2016, "Filmic SMAA").
vec4 resampled(vec2 uv) {
    vec2 size = vec2(textureSize(history, 0));
    vec2 at = uv * size;
    vec2 middle = floor(at - 0.5) + 0.5;
    vec2 f = at - middle;
    vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f));
    vec2 w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
    vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f));
    vec2 w3 = f * f * (-0.5 + 0.5 * f);
    vec2 w12 = w1 + w2;
    vec2 t0 = (middle - 1.0) / size;
    vec2 t12 = (middle + w2 / w12) / size;
    vec2 t3 = (middle + 2.0) / size;
    float a = w12.x * w0.y, b = w0.x * w12.y, c = w12.x * w12.y, d = w3.x * w12.y, e = w12.x * w3.y;
    vec4 sum = texture(history, vec2(t12.x, t0.y)) * a + texture(history, vec2(t0.x, t12.y)) * b +
               texture(history, t12) * c + texture(history, vec2(t3.x, t12.y)) * d + texture(history, vec2(t12.x, t3.y)) * e;
    return sum / (a + b + c + d + e);
}
#endif

// The past as far as the present bears it: drawn towards the mean of what is around until it is within kWide standard deviations
// (Salvi 2016, "An excursion in temporal supersampling"; Karis 2014, "High-quality temporal supersampling", for the way there).
vec3 borne(vec3 past, vec3 mean, vec3 spread, out float beyond) {
    vec3 v = ycocg(past) - mean;
    vec3 relative = abs(v) / (kWide * spread + 1.0 / 255.0);
    beyond = max(max(relative.x, relative.y), max(relative.z, 1.0));
    return from_ycocg(mean + v / beyond);
}
#endif

void main() {
    ivec2 last = textureSize(picture, 0) - 1;
    vec2 here = gl_FragCoord.xy * ratio - shift;  // where the middle of drawn pixel p is p + 0.5
    ivec2 nearest = clamp(ivec2(floor(here)), ivec2(0), last);
#ifdef WITH_HISTORY
    // The samples of this frame, by how near the pixel's middle they are.
    ivec2 base = ivec2(floor(here - 0.5));
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int k = 0; k < 4; ++k) {
        ivec2 p = clamp(base + ivec2(k & 1, k >> 1), ivec2(0), last);
        vec2 d = (vec2(p) + 0.5 - here) / ratio;
        float w = exp2(-kSharp * dot(d, d));
        sum += w * texelFetch(picture, p, 0).rgb;
        weights += w;
    }
    vec2 between = here / vec2(last + 1);
    vec4 spread = texture(guide_spread, between);
    vec3 mean = texture(guide_mean, between).rgb;
#ifdef MOVING
    vec3 moved = texelFetch(guide_motion, nearest, 0).xyz;
    vec2 motion = moved.xy;
    vec2 whole = vec2(textureSize(history, 0));
    vec4 past = resampled(gl_FragCoord.xy / whole - motion);
    float way = clamp(length(motion * whole) * 4.0, 0.0, 1.0);  // a quarter of a pixel blurs as a whole one
    float most = min(most_known, mix(most_known, kMostMoving, way));
    most *= spread.a * moved.z;
#else
    vec4 past = texelFetch(history, ivec2(gl_FragCoord.xy), 0);
    float most = most_known;
#endif
    bool good = past.a > 0.0 && !is_bad(past);
    float known = good ? min(past.a, most) : 0.0;
    float beyond;
    vec3 kept = borne(good ? past.rgb : vec3(0.0), mean, spread.rgb, beyond);
    known /= beyond * beyond;
    sum += known * kept;
    weights += known;
    // Pixels of which little is known are few: where there is none this is not run through.
    float unknown = clamp(1.0 - known, 0.0, 1.0);
    while (unknown > 0.0) {
        sum += kOwn * unknown * along_edges(nearest, here);
        weights += kOwn * unknown;
        unknown = 0.0;
    }
    out_picture = vec4(sum / weights, weights);
#else
    out_picture = vec4(along_edges(nearest, here), kOwn);
#endif
}
