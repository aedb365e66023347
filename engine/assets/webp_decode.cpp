#include "lanthorn/assets/webp_decode.h"

#include <fmt/format.h>
#include <webp/decode.h>
#include <webp/demux.h>

#include <algorithm>
#include <memory>

namespace lanthorn {

namespace {

const char* words_of(VP8StatusCode status) {
    switch (status) {
        case VP8_STATUS_OUT_OF_MEMORY:
            return "not enough memory";
        case VP8_STATUS_NOT_ENOUGH_DATA:
        case VP8_STATUS_SUSPENDED:
            return "the file is cut off";
        case VP8_STATUS_UNSUPPORTED_FEATURE:
            return "a kind of WebP that is not read";
        default:
            return "the file is damaged";
    }
}

// `rgba` has place for the image.
VP8StatusCode decode_still(std::span<const std::uint8_t> bytes, Image& image) {
    WebPDecoderConfig config;
    if (WebPInitDecoderConfig(&config) == 0) {
        return VP8_STATUS_INVALID_PARAM;
    }
    config.output.colorspace = MODE_RGBA;
    config.output.is_external_memory = 1;
    config.output.u.RGBA = {image.rgba.data(), static_cast<int>(4 * image.width), image.rgba.size()};
    return WebPDecode(bytes.data(), bytes.size(), &config);
}

VP8StatusCode decode_first_frame(std::span<const std::uint8_t> bytes, Image& image) {
    WebPAnimDecoderOptions options;
    if (WebPAnimDecoderOptionsInit(&options) == 0) {
        return VP8_STATUS_INVALID_PARAM;
    }
    options.color_mode = MODE_RGBA;
    const WebPData data = {bytes.data(), bytes.size()};
    const std::unique_ptr<WebPAnimDecoder, decltype(&WebPAnimDecoderDelete)> decoder(
        WebPAnimDecoderNew(&data, &options), WebPAnimDecoderDelete);
    std::uint8_t* canvas = nullptr;
    int milliseconds = 0;
    if (decoder == nullptr || WebPAnimDecoderGetNext(decoder.get(), &canvas, &milliseconds) == 0) {
        return VP8_STATUS_BITSTREAM_ERROR;
    }
    std::copy_n(canvas, image.rgba.size(), image.rgba.begin());
    return VP8_STATUS_OK;
}

}  // namespace

std::uint64_t stated_webp_texels(std::span<const std::uint8_t> bytes) {
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK) {
        return 0;
    }
    return static_cast<std::uint64_t>(features.width) * static_cast<std::uint64_t>(features.height);
}

DecodedImage decode_webp(std::span<const std::uint8_t> bytes) {
    DecodedImage result;
    WebPBitstreamFeatures features;
    VP8StatusCode status = WebPGetFeatures(bytes.data(), bytes.size(), &features);
    if (status == VP8_STATUS_OK) {
        result.problem = problem_of_size(static_cast<std::uint64_t>(features.width),
                                         static_cast<std::uint64_t>(features.height));
        if (!result.problem.empty()) {
            return result;
        }
        result.image.width = static_cast<std::uint32_t>(features.width);
        result.image.height = static_cast<std::uint32_t>(features.height);
        result.image.rgba.resize(std::size_t{4} * result.image.width * result.image.height);
        status = features.has_animation != 0 ? decode_first_frame(bytes, result.image)
                                             : decode_still(bytes, result.image);
    }
    if (status != VP8_STATUS_OK) {
        result.problem = fmt::format("cannot be decoded: {}", words_of(status));
        result.image = {};
    }
    return result;
}

}  // namespace lanthorn
