#version 450 core
// What the photons of the last bounce stand for when light is reflected on and on: their own light, and all that would follow if
// each later bounce kept the share of it that the last one did. One work group.
layout(local_size_x = 256) in;

layout(std430, binding = 5) writeonly buffer Rest { vec4 rest; };

uniform samplerBuffer photon_hits;  // PhotonHit, two texels each
uniform int photons;                // of one bounce
uniform int last_bounce;            // its first photon; those of the bounce before lie before it
uniform float most_kept;            // of the light, from bounce to bounce

shared vec3 before[256];
shared vec3 last[256];

void main() {
    int lane = int(gl_LocalInvocationID.x);
    vec3 a = vec3(0.0);
    vec3 b = vec3(0.0);
    for (int i = lane; i < photons; i += 256) {
        int at = 2 * (last_bounce + i);
        b += texelFetch(photon_hits, at).w > 0.0 ? texelFetch(photon_hits, at + 1).rgb : vec3(0.0);
        at -= 2 * photons;
        a += texelFetch(photon_hits, at).w > 0.0 ? texelFetch(photon_hits, at + 1).rgb : vec3(0.0);
    }
    before[lane] = a;
    last[lane] = b;
    barrier();
    for (int half_of = 128; half_of > 0; half_of >>= 1) {
        if (lane < half_of) {
            before[lane] += before[lane + half_of];
            last[lane] += last[lane + half_of];
        }
        barrier();
    }
    if (lane == 0) {
        vec3 kept = min(last[0] / max(before[0], vec3(1e-30)), vec3(most_kept));
        rest = vec4(1.0 / (1.0 - kept), 0.0);
    }
}
