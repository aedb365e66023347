#include "lanthorn/render/sky_texture.h"

#include <algorithm>
#include <vector>

namespace lanthorn::render {

namespace {

constexpr float kMostStored = 65000;  // RGB9_E5 ends at 65408

}  // namespace

void SkyTexture::follow(const FrameScene& scene) {
    if (!scene.sky) {
        image_.reset();
        texture_ = {};
        return;
    }
    const SkyInstance& sky = *scene.sky;
    to_sky_ = sky.to_sky;
    if (image_ != sky.sky.image) {
        image_ = sky.sky.image;
        GLint largest = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
        SkyImage smaller;
        const SkyImage* shown = image_.get();
        if (static_cast<GLint>(std::max(shown->width, shown->height)) > largest) {
            smaller = coarser(*image_, static_cast<std::uint32_t>(largest) / 2);
            shown = &smaller;
        }
        float most = 0;
        for (const vec3& c : shown->radiance) {
            most = std::max({most, c.x, c.y, c.z});
        }
        unit_ = std::max(most / kMostStored, 1.0f);
        std::vector<vec3> stored(shown->radiance.size());
        std::ranges::transform(shown->radiance, stored.begin(), [&](const vec3& c) { return c / unit_; });
        const ivec2 size(shown->width, shown->height);
        texture_ = gpu::Texture::make_2d(GL_RGB9_E5, size);
        glTextureSubImage2D(texture_.id(), 0, 0, 0, size.x, size.y, GL_RGB, GL_FLOAT, stored.data());
        texture_.set_filter(GL_LINEAR, GL_LINEAR);
        glTextureParameteri(texture_.id(), GL_TEXTURE_WRAP_S, GL_REPEAT);
    }
    scale_ = sky.scale() * unit_;
}

}  // namespace lanthorn::render
