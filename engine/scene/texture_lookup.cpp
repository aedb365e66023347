#include "engine/scene/texture_lookup.h"

#include <array>
#include <cmath>

#include "lanthorn/core/colour.h"

namespace lanthorn {

namespace {

const std::array<float, 256>& decoded() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (std::size_t i = 0; i < t.size(); ++i) {
            t[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / 255));
        }
        return t;
    }();
    return table;
}

// The texel that `i`, any integer, stands for (OpenGL 4.5, table 8.20).
int wrapped(int i, int size, Wrap wrap) {
    const auto modulo = [](int a, int b) { return (a % b + b) % b; };
    switch (wrap) {
        case Wrap::clamp_to_edge:
            return glm::clamp(i, 0, size - 1);
        case Wrap::mirrored_repeat: {
            const int m = modulo(i, 2 * size);
            return m < size ? m : 2 * size - 1 - m;
        }
        case Wrap::repeat:
            break;
    }
    return modulo(i, size);
}

vec4 texel(const Image& image, int x, int y, bool srgb) {
    const std::size_t at = 4 * (static_cast<std::size_t>(y) * image.width + static_cast<std::size_t>(x));
    const std::uint8_t* p = &image.rgba[at];
    const vec4 plain = vec4(p[0], p[1], p[2], p[3]) * (1.0f / 255.0f);
    if (!srgb) {
        return plain;
    }
    const auto& table = decoded();
    return {table[p[0]], table[p[1]], table[p[2]], plain.w};
}

}  // namespace

vec4 sample_texture(const SceneAssets& assets, const Texture& texture, vec2 uv, bool srgb) {
    const Image& image = assets.images[texture.image];
    const auto width = static_cast<int>(image.width), height = static_cast<int>(image.height);
    if (width < 1 || height < 1 || !(std::abs(uv.x) < 1e6f && std::abs(uv.y) < 1e6f)) {
        return vec4(1);
    }
    const Sampler& sampler = texture.sampler;
    const auto at = [&](int x, int y) {
        return texel(image, wrapped(x, width, sampler.wrap_s), wrapped(y, height, sampler.wrap_t), srgb);
    };
    const vec2 p = uv * vec2(width, height);
    if (sampler.mag == Filter::nearest) {
        return at(static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)));
    }
    const vec2 base = glm::floor(p - 0.5f);
    const vec2 f = p - 0.5f - base;
    const int x = static_cast<int>(base.x), y = static_cast<int>(base.y);
    return glm::mix(glm::mix(at(x, y), at(x + 1, y), f.x), glm::mix(at(x, y + 1), at(x + 1, y + 1), f.x),
                    f.y);
}

}  // namespace lanthorn
