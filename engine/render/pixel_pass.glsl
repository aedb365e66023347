// A pass over every pixel of a picture, in either stage: the file that is compiled defines `vec4 pixel_value(ivec2 pixel, vec2 uv)`, of
// a pixel and its centre (0..1 from the lower left), and includes this behind it; a .comp file defines COMPUTE before.
#ifdef COMPUTE
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) writeonly uniform image2D pixel_target;

void main() {
    ivec2 size = imageSize(pixel_target);
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, size))) return;
    imageStore(pixel_target, pixel, pixel_value(pixel, (vec2(pixel) + 0.5) / vec2(size)));
}
#else
layout(location = 0) out vec4 out_value;

in vec2 uv;

void main() { out_value = pixel_value(ivec2(gl_FragCoord.xy), uv); }
#endif
