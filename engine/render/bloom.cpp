#include "engine/render/bloom.h"

#include <algorithm>

#include "engine/render/fullscreen.h"

namespace lanthorn::render {

namespace {

constexpr std::size_t kMostLevels = 7;
constexpr int kSmallest = 2;  // texels of a level's shorter side

ivec2 divided(ivec2 size, int by) {
    return (size + by - 1) / by;
}

}  // namespace

Bloom::Bloom(ivec2 size)
    : tile_({"engine/render/fullscreen.vert", "engine/render/bloom_tile.frag"}),
      down_({"engine/render/fullscreen.vert", "engine/render/bloom_down.frag"}),
      up_({"engine/render/fullscreen.vert", "engine/render/bloom_up.frag"}) {
    for (ivec2 side = divided(size, kFirst); levels_.size() < kMostLevels; side = divided(side, 2)) {
        Level level;
        level.size = side;
        level.light = gpu::Texture::make_2d(GL_RGBA32F, side);
        level.sum = gpu::Texture::make_2d(GL_RGBA32F, side);
        level.to_light = gpu::Framebuffer({&level.light}, nullptr);
        level.to_sum = gpu::Framebuffer({&level.sum}, nullptr);
        levels_.push_back(std::move(level));
        if (std::min(side.x, side.y) <= kSmallest) {
            break;
        }
    }
}

void Bloom::scatter(const gpu::Texture& radiance, float spread) {
    tile_.set("radiance", 0);
    radiance.bind(0);
    draw_fullscreen(tile_, levels_.front().to_light, levels_.front().size);
    down_.set("finer", 0);
    for (std::size_t i = 1; i < levels_.size(); ++i) {
        levels_[i - 1].light.bind(0);
        draw_fullscreen(down_, levels_[i].to_light, levels_[i].size);
    }
    up_.set("own", 0);
    up_.set("wider", 1);
    for (std::size_t i = levels_.size(); i-- > 0;) {
        const bool widest = i + 1 == levels_.size();
        levels_[i].light.bind(0);
        (widest ? levels_[i].light : levels_[i + 1].sum).bind(1);
        up_.set("spread", widest ? 0.0f : spread);
        draw_fullscreen(up_, levels_[i].to_sum, levels_[i].size);
    }
}

}  // namespace lanthorn::render
