#version 450 core
// What lit texels reflect in all: the lamps' light, and the sky's. A texel that is not lit says so in both.
layout(local_size_x = 256) in;

#include "gi_module/techniques/emc/gather/point_lists.glsl"

// By place, lux; a < 0: not lit.
layout(std430, binding = 4) buffer Radiosity { vec4 radiosity[]; };
layout(std430, binding = 5) buffer FromSky { vec4 from_sky[]; };
layout(std430, binding = 6) readonly buffer First { vec4 first[]; };

uniform int places;
uniform bool lamps;  // `radiosity` holds what their light becomes; none: `first` is what is reflected

void main() {
    int place = int(work_item());
    if (place >= places) return;
    vec4 of_lamps = lamps ? radiosity[place] : first[place];
    bool lit = of_lamps.a >= 0.0;
    vec3 of_sky = max(from_sky[place].rgb, vec3(0.0));
    radiosity[place] = lit ? vec4(of_lamps.rgb + of_sky, 0.0) : vec4(0.0, 0.0, 0.0, -1.0);
    from_sky[place] = lit ? vec4(of_sky, 0.0) : vec4(0.0, 0.0, 0.0, -1.0);
}
