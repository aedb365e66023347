// libpng, made safe: what both readers of PNG files stand on.
#pragma once

#include <png.h>

#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace lanthorn {

// Reads one file; prints nothing. Colour spaces in the file are ignored, as glTF 2.0, 3.8.3, asks. libpng
// leaves by longjmp, so nothing that must be destroyed may live in the functions that call it.
class PngReader {
  public:
    enum class Texts { skipped, kept };

    explicit PngReader(std::span<const std::uint8_t> bytes, Texts texts = Texts::skipped);
    ~PngReader();
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    // Size and depth. False: message() says why.
    bool read_header();
    // Whether so many rows can be in so many bytes: deflate packs at most 1032 to 1. After read_header().
    bool fits() const;

    // What read_rows() gives: palettes and less than 8 bits become 8 bits, a colour that is keyed out alpha.
    // Call one of them, after read_header(). False: message() says why.
    bool expect_rgba8();      // four channels of 8 bits; grey becomes RGB, absent alpha 255
    bool expect_as_stored();  // channels() of bits(): 8, or 16 in the processor's byte order

    // `rows` are `height` rows of width * channels() * bits() / 8 bytes. False: message() says why.
    bool read_rows(png_bytep* rows);

    const char* message() const { return message_; }
    std::size_t channels() const { return channels_; }
    std::size_t bits() const { return bits_; }
    // Texts.kept: keys and values, those behind the rows after read_rows() alone.
    std::map<std::string, std::string> texts();

    std::uint64_t width = 0, height = 0;  // texels

  private:
    [[noreturn]] static void fail(png_structp png, png_const_charp message);
    static void take(png_structp png, png_bytep to, std::size_t size);

    std::span<const std::uint8_t> rest_;
    std::size_t file_size_;
    Texts texts_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::uint64_t row_bytes_ = 0;  // as in the file
    std::size_t channels_ = 0, bits_ = 0;
    char message_[128] = {};
};

}  // namespace lanthorn
