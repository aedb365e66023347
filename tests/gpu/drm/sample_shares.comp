#version 450 core
// The equations of solid_angle.glsl as the gather uses them: x what share_of_sample() gives a receiver at the origin, y drm_area() of
// the fields across and area, z drm_solid_angle_11() of across, w drm_sent_15() of sent and across.
layout(local_size_x = 1) in;

#include "gi_module/techniques/drm/drm_gather.glsl"

layout(std430, binding = 5) readonly buffer Normals { vec4 normals[]; };
layout(std430, binding = 6) writeonly buffer Results { vec4 results[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    RadianceSample s = radiance_samples[i];
    results[i] = vec4(share_of_sample(s, s.position, normals[i].xyz), drm_area(s.across, s.area),
                      drm_solid_angle_11(s.across), drm_sent_15(s.sent, s.across).x);
}
