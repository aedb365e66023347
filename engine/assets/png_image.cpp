#include "engine/assets/png_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/assets/image_decode.h"
#include "engine/assets/image_metadata.h"
#include "engine/assets/png_reader.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

// What was read, in rows without gaps, to 0..1.
template <typename T>
void append_values(std::vector<float>& values, const std::vector<std::uint8_t>& bytes) {
    values.reserve(bytes.size() / sizeof(T));
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(T)) {
        T value;
        std::memcpy(&value, &bytes[at], sizeof(T));
        values.push_back(static_cast<float>(value) * (1.0f / static_cast<float>(T(-1))));
    }
}

// libpng leaves by longjmp, so nothing that must be destroyed may live in the functions that call it.
class PngWriter {
  public:
    explicit PngWriter(std::string& out) : out_(out) {
        png_ =
            png_create_write_struct(PNG_LIBPNG_VER_STRING, this, fail, [](png_structp, png_const_charp) {});
        info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
    }
    ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    // False: message() says why.
    bool write(const ImageF& image, png_bytep* rows, std::vector<png_text>& texts) {
        if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) {
            return false;
        }
        constexpr int kTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                  PNG_COLOR_TYPE_RGB_ALPHA};
        png_set_write_fn(png_, this, append, [](png_structp) {});
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(image.width),
                     static_cast<png_uint_32>(image.height), 8, kTypes[image.channels - 1],
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_RELATIVE);
        png_set_text(png_, info_, texts.data(), static_cast<int>(texts.size()));
        png_write_info(png_, info_);
        png_write_image(png_, rows);
        png_write_end(png_, nullptr);
        return true;
    }
    const char* message() const { return message_; }

  private:
    [[noreturn]] static void fail(png_structp png, png_const_charp message) {
        auto* writer = static_cast<PngWriter*>(png_get_error_ptr(png));
        std::strncpy(writer->message_, message, sizeof writer->message_ - 1);
        png_longjmp(png, 1);
    }
    static void append(png_structp png, png_bytep from, std::size_t size) {
        static_cast<PngWriter*>(png_get_io_ptr(png))->out_.append(reinterpret_cast<const char*>(from), size);
    }

    std::string& out_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    char message_[128] = {};
};

}  // namespace

ImageF read_png(const std::string& name, std::span<const std::uint8_t> bytes) {
    PngReader reader(bytes, PngReader::Texts::kept);
    if (!reader.read_header()) {
        throw InputError(name, "", fmt::format("cannot be read as an image: {}", reader.message()));
    }
    std::string problem = problem_of_size(reader.width, reader.height);
    if (problem.empty() && !reader.fits()) {
        problem = problem_of_too_few_bytes(reader.width, reader.height, bytes.size());
    }
    if (!problem.empty()) {
        throw InputError(name, "", problem);
    }
    const bool known = reader.expect_as_stored();
    const std::size_t row = reader.width * reader.channels() * reader.bits() / 8;
    std::vector<std::uint8_t> stored(row * reader.height);
    std::vector<png_bytep> rows(reader.height);
    for (std::size_t y = 0; y < rows.size(); ++y) {
        rows[y] = stored.data() + row * y;
    }
    if (!known || !reader.read_rows(rows.data())) {
        throw InputError(name, "", fmt::format("cannot be read to its end: {}", reader.message()));
    }
    ImageF image;
    image.width = static_cast<int>(reader.width);
    image.height = static_cast<int>(reader.height);
    image.channels = static_cast<int>(reader.channels());
    if (reader.bits() == 16) {
        append_values<std::uint16_t>(image.pixels, stored);
    } else {
        append_values<std::uint8_t>(image.pixels, stored);
    }
    for (const auto& [key, text] : reader.texts()) {
        keep_metadata(image, key, text);
    }
    return image;
}

std::string png_picture(const ImageF& image) {
    std::vector<std::uint8_t> bytes(image.pixels.size());
    std::ranges::transform(image.pixels, bytes.begin(), byte_of);
    std::vector<png_bytep> rows(static_cast<std::size_t>(image.height));
    for (std::size_t y = 0; y < rows.size(); ++y) {
        rows[y] = bytes.data() + bytes.size() / rows.size() * y;
    }
    std::vector<std::pair<std::string, std::string>> words;  // libpng takes no const
    for (const auto& [key, text] : image.metadata) {
        words.emplace_back(metadata_name(key), text);
    }
    std::vector<png_text> texts;
    for (auto& [key, text] : words) {
        // Latin-1 is all that a tEXt chunk is for.
        const bool ascii =
            std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 128; });
        png_text entry = {};
        entry.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        entry.key = key.data();
        entry.text = text.data();
        entry.text_length = ascii ? text.size() : 0;
        entry.itxt_length = ascii ? 0 : text.size();
        texts.push_back(entry);
    }
    std::string out;
    PngWriter writer(out);
    if (!writer.write(image, rows.data(), texts)) {
        throw std::runtime_error(writer.message());
    }
    return out;
}

}  // namespace lanthorn
