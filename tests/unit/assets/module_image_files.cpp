#include "tests/unit/assets/module_image_files.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>

#include <algorithm>
#include <cmath>

#include "engine/assets/image_format.h"
#include "engine/assets/module_image.h"

namespace lanthorn::module_images {

std::span<const std::uint8_t> as_bytes(const std::string& file) {
    return {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()};
}

ImageF read(const std::string& file, const std::string& ending) {
    return read_by_module("a", as_bytes(file), format_to_read(as_bytes(file), ending));
}

ImageF ramp(int width, int height, int channels) {
    ImageF image{width, height, channels, {}, {}};
    for (int i = 0; i < width * height * channels; ++i) {
        image.pixels.push_back(static_cast<float>(i % 255) / 255);
    }
    return image;
}

std::string radiance(const std::string& lines, const std::string& size, const std::string& rows) {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + lines + "\n" + size + "\n" + rows;
}

std::string rgbe(const std::array<double, 3>& colour) {
    const double most = std::max({colour[0], colour[1], colour[2]});
    int exponent = 0;
    std::frexp(most, &exponent);
    std::string pixel;
    for (const double value : colour) {
        pixel.push_back(static_cast<char>(static_cast<int>(std::ldexp(value, 8 - exponent))));
    }
    return pixel + static_cast<char>(exponent + 128);
}

std::string tiff(int width, int height, int samples, const std::string& pixels,
                 const std::vector<std::pair<int, int>>& more) {
    std::vector<std::pair<int, int>> tags = {
        {256, width},   {257, height}, {258, 8},
        {259, 1},       {262, 2},      {273, 8},
        {277, samples}, {278, height}, {279, static_cast<int>(pixels.size())}};
    tags.insert(tags.end(), more.begin(), more.end());
    std::ranges::sort(tags);
    const auto number = [](unsigned value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i) {
            text.push_back(static_cast<char>(value >> (8 * i)));
        }
        return text;
    };
    std::string body = pixels + (pixels.size() % 2 != 0 ? "\0" : "");
    std::string file = std::string("II*\0", 4) + number(static_cast<unsigned>(8 + body.size()), 4) + body +
                       number(static_cast<unsigned>(tags.size()), 2);
    for (const auto& [tag, value] : tags) {
        file += number(static_cast<unsigned>(tag), 2) + number(tag == 273 || tag == 279 ? 4 : 3, 2) +
                number(1, 4) + number(static_cast<unsigned>(value), 4);
    }
    return file + number(0, 4);
}

std::string windowed(const Imath::Box2i& full, const Imath::Box2i& window) {
    Imf::Header header(full, window);
    header.compression() = Imf::NO_COMPRESSION;
    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
    std::vector<float> pixels;
    for (int i = 0; i < width * height; ++i) {
        pixels.insert(pixels.end(), {4, 2, 1});
    }
    Imf::FrameBuffer frame;
    for (int c = 0; c < 3; ++c) {
        const char name[] = {"RGB"[c], '\0'};
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        frame.insert(name, Imf::Slice::Make(Imf::FLOAT, &pixels[static_cast<std::size_t>(c)], window, 12,
                                            static_cast<std::size_t>(12 * width)));
    }
    Imf::StdOSStream stream;
    {
        Imf::OutputFile file(stream, header, 0);
        file.setFrameBuffer(frame);
        file.writePixels(height);
    }
    return stream.str();
}

void expect_pixel(const ImageF& image, const std::array<float, 3>& expected, float tolerance) {
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(image.at(0, 0, static_cast<int>(c)), expected[c], tolerance * std::ranges::max(expected))
            << c;
    }
}

}  // namespace lanthorn::module_images
