#include "engine/assets/png_reader.h"

#include <bit>
#include <csetjmp>
#include <cstring>

namespace lanthorn {

namespace {

constexpr std::uint64_t kMostPacked = 1032;  // times, by deflate
constexpr png_uint_32 kMostTexts = 256;
constexpr png_alloc_size_t kLargestChunk = 1u << 20;  // bytes

// Whether every chunk lies in the file: libpng makes room for some before it reads them.
bool chunks_fit(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t kSignature = 8, kAround = 12;  // length, type, checksum
    for (std::size_t at = kSignature; at + kAround <= bytes.size();) {
        const std::size_t size = std::size_t{bytes[at]} << 24 | std::size_t{bytes[at + 1]} << 16 |
                                 std::size_t{bytes[at + 2]} << 8 | std::size_t{bytes[at + 3]};
        if (size > bytes.size() - at - kAround) {
            return false;
        }
        if (std::memcmp(&bytes[at + 4], "IEND", 4) == 0) {
            return true;
        }
        at += size + kAround;
    }
    return false;
}

}  // namespace

PngReader::PngReader(std::span<const std::uint8_t> bytes, Texts texts)
    : rest_(bytes), file_size_(bytes.size()), texts_(texts) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, [](png_structp, png_const_charp) {});
    info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
}

PngReader::~PngReader() {
    png_destroy_read_struct(&png_, &info_, nullptr);
}

bool PngReader::read_header() {
    if (!chunks_fit(rest_)) {
        std::strcpy(message_, "the file is cut off");
        return false;
    }
    if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) {
        return false;
    }
    png_set_read_fn(png_, this, take);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    // What is no picture would take memory for as much as a sender likes.
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
    png_set_chunk_cache_max(png_, texts_ == Texts::kept ? kMostTexts : 1);  // 1: keeps none
    png_set_chunk_malloc_max(png_, kLargestChunk);
    png_set_crc_action(png_, PNG_CRC_DEFAULT, PNG_CRC_QUIET_USE);
    png_read_info(png_, info_);
    width = png_get_image_width(png_, info_);
    height = png_get_image_height(png_, info_);
    row_bytes_ = png_get_rowbytes(png_, info_);
    return true;
}

bool PngReader::fits() const {
    return row_bytes_ * height / kMostPacked <= file_size_;
}

bool PngReader::expect_rgba8() {
    if (setjmp(png_jmpbuf(png_)) != 0) {
        return false;
    }
    png_set_expand(png_);
    png_set_scale_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, 255, PNG_FILLER_AFTER);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    channels_ = 4;
    bits_ = 8;
    return true;
}

bool PngReader::expect_as_stored() {
    if (setjmp(png_jmpbuf(png_)) != 0) {
        return false;
    }
    png_set_expand(png_);
    if (std::endian::native == std::endian::little) {
        png_set_swap(png_);
    }
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    channels_ = png_get_channels(png_, info_);
    bits_ = png_get_bit_depth(png_, info_);
    return true;
}

bool PngReader::read_rows(png_bytep* rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) {
        return false;
    }
    png_read_image(png_, rows);
    png_read_end(png_, info_);
    return true;
}

std::map<std::string, std::string> PngReader::texts() {
    png_textp text = nullptr;
    int count = 0;
    png_get_text(png_, info_, &text, &count);
    std::map<std::string, std::string> result;
    for (int i = 0; i < count; ++i) {
        result[text[i].key] = text[i].text != nullptr ? text[i].text : "";
    }
    return result;
}

void PngReader::fail(png_structp png, png_const_charp message) {
    auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
    std::strncpy(reader->message_, message, sizeof reader->message_ - 1);
    png_longjmp(png, 1);
}

void PngReader::take(png_structp png, png_bytep to, std::size_t size) {
    auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
    if (size > reader->rest_.size()) {
        png_error(png, "the file is cut off");
    }
    std::memcpy(to, reader->rest_.data(), size);
    reader->rest_ = reader->rest_.subspan(size);
}

}  // namespace lanthorn
