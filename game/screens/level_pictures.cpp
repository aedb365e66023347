#include "game/screens/level_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/error.h"

namespace lanthorn::game::ui {

namespace {

gpu::Texture upload(const ImageF& image) {
    gpu::Texture texture = gpu::Texture::make_2d(GL_RGBA8, {image.width, image.height});
    std::vector<std::uint8_t> bytes;
    bytes.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            for (int channel = 0; channel < 4; ++channel) {
                const float value = channel == 3 ? 1 : image.at(x, y, std::min(channel, image.channels - 1));
                bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f))));
            }
        }
    }
    glTextureSubImage2D(texture.id(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        bytes.data());
    texture.set_filter(GL_LINEAR, GL_LINEAR);
    return texture;
}

}  // namespace

ImTextureID LevelPictures::find(const std::filesystem::path& file) {
    const auto [found, fresh] = pictures_.try_emplace(file);
    std::error_code error;
    if (fresh && std::filesystem::is_regular_file(file, error)) {
        try {
            found->second = upload(read_image(file));
        } catch (const InputError&) {
            // A level is chosen without its picture as well.
        }
    }
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(found->second.id()));
}

}  // namespace lanthorn::game::ui
