// The six faces of a cube map as layers of an array texture, one convention for light maps and environment maps.
// Face f looks along F with right R and up U (R x U = -F); uv = 0.5 + 0.5 * (dot(d,R), dot(d,U)) / dot(d,F).
//   0 +X (R +Z, U +Y)   1 -X (R -Z, U +Y)   2 +Y (R +X, U +Z)   3 -Y (R -X, U +Z)   4 +Z (R -X, U +Y)   5 -Z (R +X, U +Y)
#ifndef LANTHORN_CUBE_GLSL
#define LANTHORN_CUBE_GLSL

// Direction (any length) to face and uv in 0..1.
vec3 cube_face_uv(vec3 d) {  // xy = uv, z = face
    vec3 a = abs(d);
    vec2 p;
    float face;
    float major;
    if (a.x >= a.y && a.x >= a.z) {
        bool positive = d.x > 0.0;
        face = positive ? 0.0 : 1.0;
        p = vec2(positive ? d.z : -d.z, d.y);
        major = a.x;
    } else if (a.y >= a.z) {
        bool positive = d.y > 0.0;
        face = positive ? 2.0 : 3.0;
        p = vec2(positive ? d.x : -d.x, d.z);
        major = a.y;
    } else {
        bool positive = d.z > 0.0;
        face = positive ? 4.0 : 5.0;
        p = vec2(positive ? -d.x : d.x, d.y);
        major = a.z;
    }
    return vec3(p * (0.5 / max(major, 1e-30)) + 0.5, face);
}

// Face and uv (0..1) to an unnormalised direction with dot(d, F) = 1.
vec3 cube_direction(int face, vec2 uv) {
    vec2 p = uv * 2.0 - 1.0;
    if (face == 0) return vec3(1.0, p.y, p.x);
    if (face == 1) return vec3(-1.0, p.y, -p.x);
    if (face == 2) return vec3(p.x, 1.0, p.y);
    if (face == 3) return vec3(-p.x, -1.0, p.y);
    if (face == 4) return vec3(-p.x, p.y, 1.0);
    return vec3(p.x, p.y, -1.0);
}

// Clip position of `q` (relative to the cube's centre) on a face: reversed infinite depth, near plane at `near`.
vec4 cube_clip(int face, vec3 q, float near) {
    vec3 v;
    if (face == 0) v = vec3(q.z, q.y, q.x);
    else if (face == 1) v = vec3(-q.z, q.y, -q.x);
    else if (face == 2) v = vec3(q.x, q.z, q.y);
    else if (face == 3) v = vec3(-q.x, q.z, -q.y);
    else if (face == 4) v = vec3(-q.x, q.y, q.z);
    else v = vec3(q.x, q.y, -q.z);
    return vec4(v.xy, near, v.z);
}

#endif
