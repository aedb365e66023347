#include "lanthorn/assets/png_decode.h"

#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <cstring>
#include <string>
#include <vector>

namespace lanthorn {

namespace {

constexpr std::uint64_t kMostPacked = 1032;  // times, by deflate

// libpng leaves by longjmp, so nothing that must be destroyed may live in the functions that call it.
class PngReader {
  public:
    explicit PngReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, [](png_structp, png_const_charp) {});
        info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
    }
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    // Size and depth. False: message() says why.
    bool read_header() {
        if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) {
            return false;
        }
        png_set_read_fn(png_, this, take);
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        // Texts and what else is no picture: memory for as much as a sender likes.
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
        png_set_chunk_cache_max(png_, 1);  // keeps none
        png_set_chunk_malloc_max(png_, 1u << 20);
        png_set_crc_action(png_, PNG_CRC_DEFAULT, PNG_CRC_QUIET_USE);
        png_read_info(png_, info_);
        width = png_get_image_width(png_, info_);
        height = png_get_image_height(png_, info_);
        row_bytes = png_get_rowbytes(png_, info_);
        return true;
    }
    // `rows` are `height` rows of 4 * `width` bytes.
    bool read_rows(png_bytep* rows) {
        if (setjmp(png_jmpbuf(png_)) != 0) {
            return false;
        }
        png_set_expand(png_);
        png_set_scale_16(png_);
        png_set_gray_to_rgb(png_);
        png_set_add_alpha(png_, 255, PNG_FILLER_AFTER);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        png_read_image(png_, rows);
        png_read_end(png_, nullptr);
        return true;
    }
    const char* message() const { return message_; }

    std::uint64_t width = 0, height = 0;  // texels
    std::uint64_t row_bytes = 0;          // as in the file

  private:
    [[noreturn]] static void fail(png_structp png, png_const_charp message) {
        auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
        std::strncpy(reader->message_, message, sizeof reader->message_ - 1);
        png_longjmp(png, 1);
    }
    static void take(png_structp png, png_bytep to, std::size_t size) {
        auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
        if (size > reader->rest_.size()) {
            png_error(png, "the file is cut off");
        }
        std::memcpy(to, reader->rest_.data(), size);
        reader->rest_ = reader->rest_.subspan(size);
    }

    std::span<const std::uint8_t> rest_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    char message_[128] = {};
};

// Whether so many rows can be in so many bytes.
bool fits(const PngReader& reader, std::span<const std::uint8_t> bytes) {
    return reader.row_bytes * reader.height / kMostPacked <= bytes.size();
}

}  // namespace

std::uint64_t stated_png_texels(std::span<const std::uint8_t> bytes) {
    PngReader reader(bytes);
    return reader.read_header() && fits(reader, bytes) ? reader.width * reader.height : 0;
}

DecodedImage decode_png(std::span<const std::uint8_t> bytes) {
    DecodedImage result;
    PngReader reader(bytes);
    if (!reader.read_header()) {
        result.problem = fmt::format("cannot be decoded: {}", reader.message());
        return result;
    }
    const std::uint64_t texels = reader.width * reader.height;
    if (texels == 0 || texels > kMaxDecodedTexels) {
        result.problem = fmt::format("has {} x {} texels, expected 1 to {}", reader.width, reader.height,
                                     kMaxDecodedTexels);
        return result;
    }
    if (!fits(reader, bytes)) {
        result.problem = fmt::format("has {} x {} texels in {} bytes: it is cut off", reader.width,
                                     reader.height, bytes.size());
        return result;
    }
    result.image.rgba.resize(4 * texels);
    std::vector<png_bytep> rows(reader.height);
    for (std::size_t y = 0; y < rows.size(); ++y) {
        rows[y] = result.image.rgba.data() + 4 * reader.width * y;
    }
    if (!reader.read_rows(rows.data())) {
        result.problem = fmt::format("cannot be decoded: {}", reader.message());
        result.image = {};
        return result;
    }
    result.image.width = static_cast<std::uint32_t>(reader.width);
    result.image.height = static_cast<std::uint32_t>(reader.height);
    return result;
}

}  // namespace lanthorn
