#include "engine/image_module/write_picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace lanthorn {

namespace {

// NaN becomes 0.
float limited(float value) {
    return value > 0 ? std::min(value, 1.0f) : 0.0f;
}

// Formats of 10 to 16 bits get 16.
std::vector<std::uint16_t> whole_numbers(const std::vector<float>& pixels) {
    std::vector<std::uint16_t> numbers(pixels.size());
    std::ranges::transform(pixels, numbers.begin(), [](float v) {
        return static_cast<std::uint16_t>(std::lround(limited(v) * 65535));
    });
    return numbers;
}

// The nearest of 8 bits, as PNG has it.
std::vector<std::uint8_t> bytes_of(const std::vector<float>& pixels) {
    std::vector<std::uint8_t> bytes(pixels.size());
    std::ranges::transform(pixels, bytes.begin(),
                           [](float v) { return static_cast<std::uint8_t>(std::lround(limited(v) * 255)); });
    return bytes;
}

// What RGBE can hold: nothing below 0, no NaN.
std::vector<float> radiances(std::vector<float> pixels) {
    for (float& v : pixels) {
        v = v > 0 ? std::min(v, 0x1.fep126f) : 0.0f;
    }
    return pixels;
}

bool write_values(OIIO::ImageOutput& output, const ImageF& image, const std::string& format, bool linear) {
    if (format == "hdr") {
        return output.write_image(OIIO::TypeDesc::FLOAT, radiances(image.pixels).data());
    }
    if (linear) {
        return output.write_image(OIIO::TypeDesc::FLOAT, image.pixels.data());
    }
    return format == "dpx" ? output.write_image(OIIO::TypeDesc::UINT16, whole_numbers(image.pixels).data())
                           : output.write_image(OIIO::TypeDesc::UINT8, bytes_of(image.pixels).data());
}

void write(const ImageF& image, const std::string& format, bool linear, PictureSink& sink) {
    OIIO::attribute("threads", 1);
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    if (!output) {
        throw std::runtime_error("cannot be written: " + OIIO::geterror());
    }
    OIIO::ImageSpec spec(image.width, image.height, image.channels,
                         linear            ? OIIO::TypeDesc::FLOAT
                         : format == "dpx" ? OIIO::TypeDesc::UINT16
                                           : OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("CompressionQuality", 95);
    if (format == "tiff") {
        spec.attribute("compression", "zip");
    }
    if (format != "hdr" && !linear) {
        spec.attribute("oiio:ColorSpace", "sRGB");
    }
    std::vector<unsigned char> whole;
    OIIO::Filesystem::IOVecOutput memory(whole);
    if (!output->set_ioproxy(&memory) || !output->open("memory." + format, spec) ||
        !write_values(*output, image, format, linear) || !output->close()) {
        throw std::runtime_error("cannot be written: " + output->geterror());
    }
    sink.bytes(whole);
}

}  // namespace

void write_picture(const ImageF& image, std::string_view format, bool linear, PictureSink& sink) {
    try {
        write(image, std::string(format), linear, sink);
    } catch (const std::bad_alloc&) {
        sink.problem("cannot be written: not enough memory");
    } catch (const std::exception& error) {
        sink.problem(error.what());
    }
}

}  // namespace lanthorn
