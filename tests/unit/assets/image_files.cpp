#include "tests/unit/assets/image_files.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfTiledOutputFile.h>
#include <half.h>
#include <png.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <jpeglib.h>  // after <cstdio>

namespace lanthorn {

namespace {

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error("cannot make " + what);
}

struct PngLayout {
    int width, height, bits, colour_type;
    std::vector<std::uint8_t> colours, alphas;  // of a palette
};

// `rows` without gaps.
std::string png_of(const PngLayout& layout, const std::uint8_t* rows, std::size_t row_bytes) {
    std::string out;
    png_structp png = png_create_write_struct(
        PNG_LIBPNG_VER_STRING, nullptr, [](png_structp, png_const_charp text) { fail(text); }, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &out,
        [](png_structp p, png_bytep from, std::size_t size) {
            static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<const char*>(from), size);
        },
        nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(layout.width), static_cast<png_uint_32>(layout.height),
                 layout.bits, layout.colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (!layout.colours.empty()) {
        std::vector<png_color> palette(layout.colours.size() / 3);
        std::memcpy(palette.data(), layout.colours.data(), layout.colours.size());
        png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
        png_set_tRNS(png, info, layout.alphas.data(), static_cast<int>(layout.alphas.size()), nullptr);
    }
    png_write_info(png, info);
    if (layout.bits == 16 && std::endian::native == std::endian::little) {
        png_set_swap(png);
    }
    png_set_packing(png);
    for (int y = 0; y < layout.height; ++y) {
        png_write_row(png, rows + static_cast<std::size_t>(y) * row_bytes);
    }
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return out;
}

int png_type(int channels) {
    constexpr int kTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                              PNG_COLOR_TYPE_RGB_ALPHA};
    return kTypes[channels - 1];
}

}  // namespace

std::string make_png(int width, int height, const std::vector<std::uint8_t>& texels, int channels) {
    return png_of({width, height, 8, png_type(channels), {}, {}}, texels.data(),
                  static_cast<std::size_t>(width * channels));
}

std::string make_png16(int width, int height, const std::vector<std::uint16_t>& texels, int channels) {
    return png_of({width, height, 16, png_type(channels), {}, {}},
                  reinterpret_cast<const std::uint8_t*>(texels.data()),
                  static_cast<std::size_t>(2 * width * channels));
}

std::string make_palette_png(int width, int height, const std::vector<std::uint8_t>& indices, int bits,
                             const std::vector<std::uint8_t>& colours,
                             const std::vector<std::uint8_t>& alphas) {
    return png_of({width, height, bits, PNG_COLOR_TYPE_PALETTE, colours, alphas}, indices.data(),
                  static_cast<std::size_t>(width));
}

std::string make_webp(int width, int height, const std::vector<std::uint8_t>& texels, int channels) {
    const auto encode = channels == 4 ? WebPEncodeLosslessRGBA : WebPEncodeLosslessRGB;
    std::uint8_t* out = nullptr;
    const std::size_t size = encode(texels.data(), width, height, width * channels, &out);
    if (size == 0) {
        fail("a WebP");
    }
    std::string bytes(reinterpret_cast<const char*>(out), size);
    WebPFree(out);
    return bytes;
}

std::string make_animated_webp(int width, int height, const std::vector<std::vector<std::uint8_t>>& frames) {
    WebPAnimEncoder* encoder = WebPAnimEncoderNew(width, height, nullptr);
    WebPConfig config;
    WebPConfigInit(&config);
    config.lossless = 1;
    config.exact = 1;
    int milliseconds = 0;
    for (const std::vector<std::uint8_t>& frame : frames) {
        WebPPicture picture;
        WebPPictureInit(&picture);
        picture.use_argb = 1;
        picture.width = width;
        picture.height = height;
        if (WebPPictureImportRGBA(&picture, frame.data(), 4 * width) == 0 ||
            WebPAnimEncoderAdd(encoder, &picture, milliseconds, &config) == 0) {
            fail("a WebP");
        }
        WebPPictureFree(&picture);
        milliseconds += 40;
    }
    WebPData data = {};
    if (WebPAnimEncoderAdd(encoder, nullptr, milliseconds, nullptr) == 0 ||
        WebPAnimEncoderAssemble(encoder, &data) == 0) {
        fail("a WebP");
    }
    std::string bytes(reinterpret_cast<const char*>(data.bytes), data.size);
    WebPDataClear(&data);
    WebPAnimEncoderDelete(encoder);
    return bytes;
}

std::string make_jpeg(int width, int height, const std::vector<std::uint8_t>& texels, int channels,
                      JpegKind kind) {
    jpeg_compress_struct jpeg = {};
    jpeg_error_mgr errors = {};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* out = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &out, &size);
    jpeg.image_width = static_cast<JDIMENSION>(width);
    jpeg.image_height = static_cast<JDIMENSION>(height);
    jpeg.input_components = channels;
    jpeg.in_color_space = channels == 1 ? JCS_GRAYSCALE : channels == 3 ? JCS_RGB : JCS_CMYK;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 100, TRUE);
    jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = 1;
    if (kind == JpegKind::progressive) {
        jpeg_simple_progression(&jpeg);
    }
    if (channels == 4) {
        jpeg_set_colorspace(&jpeg, JCS_CMYK);
        jpeg.write_Adobe_marker = kind == JpegKind::adobe_cmyk;
    }
    jpeg_start_compress(&jpeg, TRUE);
    for (int y = 0; y < height; ++y) {
        auto* row = const_cast<JSAMPROW>(texels.data() + static_cast<std::size_t>(y * width * channels));
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    std::string bytes(reinterpret_cast<const char*>(out), size);
    std::free(out);
    return bytes;
}

std::string make_exr(int width, int height, const std::vector<float>& values,
                     const std::vector<std::string>& names, ExrKind kind) {
    const Imath::Box2i window({-3, 5}, {width - 4, height + 4});
    Imf::Header header(window, window);
    header.compression() = kind == ExrKind::tiles ? Imf::ZIPS_COMPRESSION : Imf::PIZ_COMPRESSION;
    std::vector<half> halves(values.begin(), values.end());
    std::vector<std::uint32_t> numbers;
    if (kind == ExrKind::whole_numbers) {
        numbers.assign(values.begin(), values.end());
    }
    const Imf::PixelType type = numbers.empty() ? Imf::HALF : Imf::UINT;
    Imf::FrameBuffer frame;
    const std::size_t pixel = names.size() * (numbers.empty() ? sizeof(half) : sizeof(std::uint32_t));
    for (std::size_t c = 0; c < names.size(); ++c) {
        const void* first = &halves[c];
        if (!numbers.empty()) {
            first = &numbers[c];
        }
        header.channels().insert(names[c], Imf::Channel(type));
        frame.insert(names[c],
                     Imf::Slice::Make(type, first, window, pixel, pixel * static_cast<std::size_t>(width)));
    }
    Imf::StdOSStream stream;
    if (kind == ExrKind::tiles) {
        header.setTileDescription(Imf::TileDescription(7, 5, Imf::ONE_LEVEL));
        Imf::TiledOutputFile file(stream, header, 0);
        file.setFrameBuffer(frame);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    } else {
        Imf::OutputFile file(stream, header, 0);
        file.setFrameBuffer(frame);
        file.writePixels(height);
    }
    return stream.str();
}

}  // namespace lanthorn
