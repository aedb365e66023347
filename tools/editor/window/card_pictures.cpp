#include "tools/editor/window/card_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/content_hash.h"

namespace lanthorn::edit_window {

namespace fs = std::filesystem;

namespace {

// The mean of the pixels that a pixel of the smaller picture covers; the middle of one of another shape.
ImageF small(const ImageF& image, int width, int height) {
    ImageF result{width, height, 3, std::vector<float>(static_cast<std::size_t>(3 * width * height)), {}};
    const double scale =
        std::min(static_cast<double>(image.width) / width, static_cast<double>(image.height) / height);
    const double left = (image.width - scale * width) / 2, top = (image.height - scale * height) / 2;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int x0 = static_cast<int>(left + scale * x), y0 = static_cast<int>(top + scale * y);
            const int x1 = std::clamp(static_cast<int>(left + scale * (x + 1)), x0 + 1, image.width);
            const int y1 = std::clamp(static_cast<int>(top + scale * (y + 1)), y0 + 1, image.height);
            for (int c = 0; c < 3; ++c) {
                float sum = 0;
                for (int j = y0; j < y1; ++j) {
                    for (int i = x0; i < x1; ++i) {
                        sum += image.at(i, j, std::min(c, image.channels - 1));
                    }
                }
                result.at(x, y, c) = sum / static_cast<float>((x1 - x0) * (y1 - y0));
            }
        }
    }
    return result;
}

}  // namespace

fs::path CardPictures::kept_file(const fs::path& scene) const {
    if (folder_.empty()) {
        return {};
    }
    std::error_code ignored;
    const std::string name = fs::absolute(scene, ignored).lexically_normal().string();
    return folder_ / fmt::format("{:016x}.png", replay::hash_bytes(std::as_bytes(std::span(name))));
}

fs::path CardPictures::file_of(const fs::path& scene) const {
    std::error_code ignored;
    for (fs::path file : {fs::path(scene).replace_extension(".png"), kept_file(scene)}) {
        if (!file.empty() && fs::is_regular_file(file, ignored)) {
            return file;
        }
    }
    return {};
}

const gpu::Texture* CardPictures::of(const fs::path& scene) {
    const auto found = read_.find(scene);
    if (found != read_.end()) {
        return found->second ? &*found->second : nullptr;
    }
    if (!std::exchange(may_read_, false)) {
        waits_ = true;
        return nullptr;
    }
    std::optional<gpu::Texture>& texture = read_[scene];
    const fs::path file = file_of(scene);
    if (file.empty()) {
        return nullptr;
    }
    try {
        const ImageF image = small(read_image(file), kWidth, kHeight);
        std::vector<std::uint8_t> bytes;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            bytes.push_back(
                static_cast<std::uint8_t>(std::lround(255 * std::clamp(image.pixels[i], 0.0f, 1.0f))));
            if (i % 3 == 2) {
                bytes.push_back(255);
            }
        }
        texture = gpu::Texture::make_2d(GL_RGBA8, {kWidth, kHeight});
        texture->set_filter(GL_LINEAR, GL_LINEAR);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        glTextureSubImage2D(texture->id(), 0, 0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        return &*texture;
    } catch (const Error&) {  // a picture that is none: the card goes without
        return nullptr;
    }
}

bool CardPictures::next_turn() {
    may_read_ = true;
    return std::exchange(waits_, false);
}

void CardPictures::keep(const fs::path& scene, const ImageF& picture) {
    const fs::path file = kept_file(scene);
    std::error_code error;
    if (file.empty() || picture.pixels.empty() ||
        fs::is_regular_file(fs::path(scene).replace_extension(".png"), error)) {
        return;
    }
    fs::create_directories(folder_, error);
    try {
        write_image(file, small(picture, kWidth, kHeight));
        read_.erase(scene);
    } catch (const Error&) {
        read_.erase(scene);
    }
}

}  // namespace lanthorn::edit_window
