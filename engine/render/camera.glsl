// The camera: pixels to rays and back (CameraUniforms::set).
#ifndef LANTHORN_CAMERA_GLSL
#define LANTHORN_CAMERA_GLSL

uniform vec3 camera_position;
uniform vec3 camera_right;
uniform vec3 camera_up;
uniform vec3 camera_forward;
uniform int camera_orthographic;
uniform mat4 camera_clip_from_relative;

// Unit direction of the ray through `uv` (0..1, from the lower left).
vec3 pixel_direction(vec2 uv) {
    if (camera_orthographic != 0) return camera_forward;
    vec2 p = uv * 2.0 - 1.0;
    return normalize(camera_forward + camera_right * p.x + camera_up * p.y);
}

// Where that ray starts, relative to camera_position: 0 but for orthographic cameras.
vec3 pixel_origin(vec2 uv) {
    if (camera_orthographic == 0) return vec3(0.0);
    vec2 p = uv * 2.0 - 1.0;
    return camera_right * p.x + camera_up * p.y;
}

// A G-buffer distance at `uv` to a position relative to camera_position.
vec3 relative_position(vec2 uv, float distance) { return pixel_origin(uv) + pixel_direction(uv) * distance; }
// The same in render space.
vec3 render_position(vec2 uv, float distance) { return camera_position + relative_position(uv, distance); }

// G-buffer distance of a point relative to camera_position.
float camera_distance(vec3 relative) {
    return camera_orthographic != 0 ? dot(relative, camera_forward) : length(relative);
}

#endif
