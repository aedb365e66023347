#include "game/presentation/album/animated_picture.h"

#include <webp/encode.h>
#include <webp/mux.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"

namespace lanthorn::game {

namespace {

// Of the pixels from `begin` to `end`, in pixels of the picture, each by its share.
float mean(const ImageF& picture, int channel, glm::dvec2 begin, glm::dvec2 end) {
    double sum = 0, weights = 0;
    for (int y = static_cast<int>(begin.y); y < picture.height && y < end.y; ++y) {
        const double high = std::min(end.y, y + 1.0) - std::max(begin.y, double(y));
        for (int x = static_cast<int>(begin.x); x < picture.width && x < end.x; ++x) {
            const double wide = std::min(end.x, x + 1.0) - std::max(begin.x, double(x));
            sum += high * wide * static_cast<double>(picture.at(x, y, channel));
            weights += high * wide;
        }
    }
    return static_cast<float>(sum / weights);
}

// 8 bits, red, green, blue.
std::vector<std::uint8_t> scaled(const ImageF& picture, ivec2 size) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    const glm::dvec2 step = glm::dvec2(picture.width, picture.height) / glm::dvec2(size);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            for (int c = 0; c < 3; ++c) {
                const float value =
                    mean(picture, c, step * glm::dvec2(x, y), step * glm::dvec2(x + 1, y + 1));
                bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f))));
            }
        }
    }
    return bytes;
}

[[noreturn]] void fail(const char* problem) {
    throw Error(ExitCode::check_failed, std::string("animated picture: ") + problem);
}

}  // namespace

struct AnimatedPicture::Encoder {
    Encoder(ivec2 size, float quality, Coding coding) {
        WebPAnimEncoderOptions options;
        if (WebPAnimEncoderOptionsInit(&options) == 0 || WebPConfigInit(&config) == 0) {
            fail("libwebp is of another version than its headers");
        }
        if (coding == Coding::whole) {
            options.kmin = 0;
            options.kmax = 1;  // every picture is a key frame
        }
        config.quality = quality;
        config.method = 2;  // of 0..6: quick, and a tenth larger
        all = WebPAnimEncoderNew(size.x, size.y, &options);
        if (all == nullptr) {
            fail("out of memory");
        }
    }
    ~Encoder() { WebPAnimEncoderDelete(all); }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    WebPConfig config{};
    WebPAnimEncoder* all = nullptr;
};

AnimatedPicture::AnimatedPicture(ivec2 size, float quality, Coding coding)
    : encoder_(std::make_unique<Encoder>(size, quality, coding)), size_(size) {}

AnimatedPicture::~AnimatedPicture() = default;

void AnimatedPicture::add(const ImageF& picture, int milliseconds) {
    const std::vector<std::uint8_t> bytes = scaled(picture, size_);
    WebPPicture coded;
    if (WebPPictureInit(&coded) == 0) {
        fail("libwebp is of another version than its headers");
    }
    coded.use_argb = 1;
    coded.width = size_.x;
    coded.height = size_.y;
    const bool added = WebPPictureImportRGB(&coded, bytes.data(), 3 * size_.x) != 0 &&
                       WebPAnimEncoderAdd(encoder_->all, &coded, end_ms_, &encoder_->config) != 0;
    WebPPictureFree(&coded);
    if (!added) {
        fail(WebPAnimEncoderGetError(encoder_->all));
    }
    end_ms_ += milliseconds;
    ++frames_;
}

void AnimatedPicture::write(const std::filesystem::path& file) {
    WebPData data;
    WebPDataInit(&data);
    const bool whole = WebPAnimEncoderAdd(encoder_->all, nullptr, end_ms_, nullptr) != 0 &&
                       WebPAnimEncoderAssemble(encoder_->all, &data) != 0;
    if (!whole) {
        WebPDataClear(&data);
        fail(WebPAnimEncoderGetError(encoder_->all));
    }
    try {
        write_file(file, {reinterpret_cast<const char*>(data.bytes), data.size});
    } catch (...) {
        WebPDataClear(&data);
        throw;
    }
    WebPDataClear(&data);
}

}  // namespace lanthorn::game
