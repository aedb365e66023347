#include "engine/assets/webp_decode.h"

#include <fmt/format.h>
#include <webp/decode.h>
#include <webp/demux.h>

#include <memory>
#include <string>

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

// The size is at most that of `image` from (x, y) on.
VP8StatusCode decode_still(std::span<const std::uint8_t> bytes, Image& image, std::size_t x = 0,
                           std::size_t y = 0) {
    WebPDecoderConfig config;
    if (WebPInitDecoderConfig(&config) == 0) {
        return VP8_STATUS_INVALID_PARAM;
    }
    config.output.colorspace = MODE_RGBA;
    config.output.is_external_memory = 1;
    const std::size_t begin = 4 * (y * image.width + x);
    config.output.u.RGBA = {image.rgba.data() + begin, static_cast<int>(4 * image.width),
                            image.rgba.size() - begin};
    return WebPDecode(bytes.data(), bytes.size(), &config);
}

// A decoder of animations would hold two more canvases.
VP8StatusCode decode_first_frame(std::span<const std::uint8_t> bytes, Image& image) {
    const WebPData data = {bytes.data(), bytes.size()};
    const std::unique_ptr<WebPDemuxer, decltype(&WebPDemuxDelete)> file(WebPDemux(&data), WebPDemuxDelete);
    WebPIterator frame = {};
    if (file == nullptr || WebPDemuxGetFrame(file.get(), 1, &frame) == 0) {
        return VP8_STATUS_BITSTREAM_ERROR;
    }
    const auto x = static_cast<std::uint64_t>(frame.x_offset), y = static_cast<std::uint64_t>(frame.y_offset);
    const bool inside = x + static_cast<std::uint64_t>(frame.width) <= image.width &&
                        y + static_cast<std::uint64_t>(frame.height) <= image.height;
    const VP8StatusCode status = inside
                                     ? decode_still({frame.fragment.bytes, frame.fragment.size}, image, x, y)
                                     : VP8_STATUS_BITSTREAM_ERROR;
    WebPDemuxReleaseIterator(&frame);
    return status;
}

std::string problem_of(const WebPBitstreamFeatures& features, std::size_t bytes) {
    const auto width = static_cast<std::uint64_t>(features.width);
    const auto height = static_cast<std::uint64_t>(features.height);
    const std::string problem = problem_of_size(width, height);
    return problem.empty() ? problem_of_packing(width, height, bytes, kMostTexelsAByte) : problem;
}

}  // namespace

std::uint64_t stated_webp_texels(std::span<const std::uint8_t> bytes) {
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK ||
        !problem_of(features, bytes.size()).empty()) {
        return 0;
    }
    return static_cast<std::uint64_t>(features.width) * static_cast<std::uint64_t>(features.height);
}

DecodedImage decode_webp(std::span<const std::uint8_t> bytes) {
    DecodedImage result;
    WebPBitstreamFeatures features;
    VP8StatusCode status = WebPGetFeatures(bytes.data(), bytes.size(), &features);
    if (status == VP8_STATUS_OK) {
        result.problem = problem_of(features, bytes.size());
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
