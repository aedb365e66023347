#version 450 core
// A flame: a drop that is widest in its lower third, brightest in its middle, deeper in hue towards its rim and tip, and
// nearly clear at its foot.
layout(location = 0) in vec2 flame_at;
layout(location = 1) flat in vec3 flame_nits;

layout(location = 0) out vec4 out_radiance;  // premultiplied

void main() {
    float y = clamp(flame_at.y, 0.0, 1.0);
    float half_width = 1.9 * sqrt(y) * pow(1.0 - y, 0.85);  // about 1 at y = 0.37
    float off = abs(flame_at.x) / max(half_width, 1e-3);
    float body = 1.0 - smoothstep(0.8, 1.0, off);
    if (body <= 0.0) discard;
    // Its rim is far darker than its core: before a wall that it lights brightly it is seen by that.
    float core = (1.0 - smoothstep(0.0, 0.7, off)) * (1.0 - smoothstep(0.4, 0.85, y));
    float foot = smoothstep(0.0, 0.25, y);
    float most = max(max(flame_nits.r, flame_nits.g), max(flame_nits.b, 1e-6));
    vec3 hue = flame_nits / most;
    vec3 light = mix(0.07 * hue * hue * hue, mix(hue, vec3(1.0), 0.3), core) * most;
    float cover = body * mix(0.4, 1.0, foot);
    out_radiance = vec4(light * cover, cover);
}
