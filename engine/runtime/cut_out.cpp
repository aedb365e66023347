#include "engine/runtime/cut_out.h"

#include <cmath>

namespace lanthorn {

namespace {

// The texel that `i`, any integer, stands for (OpenGL 4.5, table 8.20).
int wrapped(int i, int size, Wrap wrap) {
    const auto modulo = [](int a, int b) { return (a % b + b) % b; };
    if (wrap == Wrap::clamp_to_edge) {
        return glm::clamp(i, 0, size - 1);
    }
    const int m = modulo(i, wrap == Wrap::mirrored_repeat ? 2 * size : size);
    return m < size ? m : 2 * size - 1 - m;
}

float texture_alpha(const SceneAssets& assets, const TextureRef& ref, const vec2& plain) {
    const Texture& texture = assets.textures[ref.texture];
    const Image& image = assets.images[texture.image];
    const ivec2 size(image.width, image.height);
    const vec2 uv(glm::dot(ref.uv_transform[0], vec3(plain, 1)),
                  glm::dot(ref.uv_transform[1], vec3(plain, 1)));
    if (size.x < 1 || size.y < 1 || !(std::abs(uv.x) < 1e6f && std::abs(uv.y) < 1e6f)) {
        return 1;
    }
    const auto at = [&](int x, int y) {
        const auto column = static_cast<std::size_t>(wrapped(x, size.x, texture.sampler.wrap_s));
        const auto row = static_cast<std::size_t>(wrapped(y, size.y, texture.sampler.wrap_t));
        return static_cast<float>(image.rgba[4 * (row * image.width + column) + 3]) / 255.0f;
    };
    const vec2 p = uv * vec2(size);
    if (texture.sampler.mag == Filter::nearest) {
        return at(static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)));
    }
    const vec2 base = glm::floor(p - 0.5f), f = p - 0.5f - base;
    const int x = static_cast<int>(base.x), y = static_cast<int>(base.y);
    return glm::mix(glm::mix(at(x, y), at(x + 1, y), f.x), glm::mix(at(x, y + 1), at(x + 1, y + 1), f.x),
                    f.y);
}

}  // namespace

bool is_cut_out(const FrameScene& scene, const InstanceShape& shape, const Material& material, std::size_t t,
                const vec3& barycentric) {
    if (material.alpha_mode != AlphaMode::mask) {
        return false;
    }
    const auto corners = shape.indices().subspan(3 * t, 3);
    const TextureRef& ref = material.base_colour_texture;
    float alpha = 0;
    vec2 uv(0);
    for (int k = 0; k < 3; ++k) {
        const Vertex vertex = shape.vertex(corners[static_cast<std::size_t>(k)]);
        alpha += barycentric[k] * vertex.colour.w;
        uv += barycentric[k] * (ref.uv_set == 1 ? vertex.uv1 : vertex.uv0);
    }
    alpha *= material.base_colour.w;
    if (ref.present()) {
        alpha *= texture_alpha(*scene.assets, ref, uv);
    }
    return alpha < material.alpha_cutoff;
}

}  // namespace lanthorn
