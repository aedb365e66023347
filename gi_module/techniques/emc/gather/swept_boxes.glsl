// The boxes that movers sweep. The C++ side: MoverPrograms. How many there are is a constant, so that the loop is unrolled: to
// index uniforms by a number costs a software rasteriser several times the test itself.
#ifndef LANTHORN_EMC_SWEPT_BOXES_GLSL
#define LANTHORN_EMC_SWEPT_BOXES_GLSL

uniform vec4 box_lower[BOXES];  // render space: where movers are and were
uniform vec4 box_upper[BOXES];

// Whether a mover may have come between a point and what lies `l` metres on in direction d. A box that the point itself lies in
// does not count, but `inside` is told.
bool crosses_a_box(vec3 x, vec3 d, float l, out bool inside) {
    vec3 inverse = 1.0 / mix(d, vec3(1e-20), lessThan(abs(d), vec3(1e-20)));
    bool crosses = false;
    inside = false;
    for (int b = 0; b < BOXES; ++b) {
        vec3 t0 = (box_lower[b].xyz - x) * inverse;
        vec3 t1 = (box_upper[b].xyz - x) * inverse;
        vec3 near = min(t0, t1);
        vec3 far = max(t0, t1);
        float enter = max(max(near.x, near.y), near.z);
        float leave = min(min(far.x, far.y), far.z);
        bool within = enter < 0.0 && leave > 0.0;
        inside = inside || within;
        crosses = crosses || (!within && max(enter, 0.0) <= min(leave, l));
    }
    return crosses;
}

#endif
