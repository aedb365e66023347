#include "engine/assets/jpeg_decode.h"

#include <fmt/format.h>

#include <csetjmp>
#include <cstdio>  // jpeglib.h wants it

#include <jpeglib.h>  // after <cstdio>

#include <jerror.h>

#include <string>
#include <vector>

namespace lanthorn {

namespace {

constexpr int kMostScans = 1000;              // a sensible progressive file has about ten
constexpr std::uint64_t kTexelsABit = 8 * 8;  // at most: Huffman codes of a block are a bit or more
constexpr const char* kCutOff = "the file is cut off";

// libjpeg leaves by longjmp, so nothing that must be destroyed may live in the functions that call it.
class JpegReader {
  public:
    explicit JpegReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {
        jpeg_.err = jpeg_std_error(&errors_);
        jpeg_.client_data = this;
        errors_.error_exit = fail;
        errors_.emit_message = warn;
        errors_.output_message = [](j_common_ptr) {};
        progress_.progress_monitor = watch;
    }
    ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    // Size and kind. False: message() says why.
    bool read_header() {
        if (setjmp(return_) != 0) {
            return false;
        }
        jpeg_create_decompress(&jpeg_);
        jpeg_.progress = &progress_;
        jpeg_mem_src(&jpeg_, bytes_.data(), bytes_.size());
        jpeg_read_header(&jpeg_, TRUE);
        width = jpeg_.image_width;
        height = jpeg_.image_height;
        return true;
    }
    // Why so many texels are not taken from so many bytes; empty if they are. Arithmetic codes have no bound.
    std::string problem() const {
        if (jpeg_.arith_code != 0) {
            return problem_of_packing(width, height, bytes_.size(), kMostTexelsAByte);
        }
        return width * height / kTexelsABit / 8 <= bytes_.size()
                   ? ""
                   : problem_of_too_few_bytes(width, height, bytes_.size());
    }
    // `rgba` is 4 * width * height bytes. False: message() says why. What follows the last row, an end marker
    // or not, is all the same.
    bool read_rows(std::uint8_t* rgba) {
        if (setjmp(return_) != 0) {
            return false;
        }
        const bool cmyk = jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK;
        jpeg_.out_color_space = cmyk ? JCS_CMYK : JCS_EXT_RGBA;
        jpeg_start_decompress(&jpeg_);
        while (jpeg_.output_scanline < jpeg_.output_height) {
            JSAMPROW row = rgba + 4 * width * jpeg_.output_scanline;
            jpeg_read_scanlines(&jpeg_, &row, 1);
            if (cmyk) {
                rgb_of_cmyk(row);
            }
        }
        if (ended_ && damage_[0] == 0 && !has_all_scans()) {
            std::snprintf(damage_, sizeof damage_, "%s", kCutOff);
        }
        return true;
    }
    const char* message() const { return message_; }
    // What was found that the rest was guessed for; usually empty.
    std::string damage() const { return damage_; }

    std::uint64_t width = 0, height = 0;  // texels

  private:
    static JpegReader& of(j_common_ptr jpeg) { return *static_cast<JpegReader*>(jpeg->client_data); }

    [[noreturn]] static void fail(j_common_ptr jpeg) {
        JpegReader& reader = of(jpeg);
        jpeg->err->format_message(jpeg, reader.message_);
        std::longjmp(reader.return_, 1);
    }
    // Data that is missing or damaged; harmless oddities of writers are passed over.
    static void warn(j_common_ptr jpeg, int level) {
        const int code = jpeg->err->msg_code;
        if (level < 0 && of(jpeg).damage_[0] == 0 &&
            (code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE || code == JWRN_ARITH_BAD_CODE ||
             code == JWRN_MUST_RESYNC)) {
            std::snprintf(of(jpeg).damage_, sizeof damage_, "%s", kCutOff);
            if (!of(jpeg).ended_) {
                jpeg->err->format_message(jpeg, of(jpeg).damage_);
            }
        }
        of(jpeg).ended_ = of(jpeg).ended_ || code == JWRN_JPEG_EOF;
    }
    // Whether nothing but the end marker is missing from a file that ends without it and whose rows were read
    // without a warning. Where that cannot be told (arithmetic codes, channels one after the other) it is
    // taken for cut off.
    bool has_all_scans() const {
        if (jpeg_.arith_code != 0 || jpeg_.progressive_mode == 0) {
            return jpeg_.arith_code == 0 && jpeg_.comps_in_scan == jpeg_.num_components;
        }
        for (int c = 0; c < jpeg_.num_components; ++c) {
            for (const int missing_bits : jpeg_.coef_bits[c]) {  // of each frequency; -1: all
                if (missing_bits != 0) {
                    return false;
                }
            }
        }
        return true;
    }
    static void watch(j_common_ptr jpeg) {
        if (jpeg->is_decompressor &&
            reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > kMostScans) {
            std::snprintf(of(jpeg).message_, sizeof message_, "more than %d scans", kMostScans);
            std::longjmp(of(jpeg).return_, 1);
        }
    }
    // Adobe's programs, which write nearly all of them, store ink inverted and say that it is theirs.
    void rgb_of_cmyk(std::uint8_t* row) const {
        const unsigned inverted = jpeg_.saw_Adobe_marker ? 0 : 255;
        for (std::uint64_t x = 0; x < width; ++x, row += 4) {
            const unsigned white = row[3] ^ inverted;
            for (int i = 0; i < 3; ++i) {
                row[i] = static_cast<std::uint8_t>(((row[i] ^ inverted) * white + 127) / 255);
            }
            row[3] = 255;
        }
    }

    std::span<const std::uint8_t> bytes_;
    jpeg_decompress_struct jpeg_ = {};
    jpeg_error_mgr errors_ = {};
    jpeg_progress_mgr progress_ = {};
    std::jmp_buf return_ = {};
    char message_[JMSG_LENGTH_MAX] = {}, damage_[JMSG_LENGTH_MAX] = {};
    bool ended_ = false;  // before an end marker
};

}  // namespace

std::uint64_t stated_jpeg_texels(std::span<const std::uint8_t> bytes) {
    JpegReader reader(bytes);
    return reader.read_header() && reader.problem().empty() ? reader.width * reader.height : 0;
}

DecodedImage decode_jpeg(std::span<const std::uint8_t> bytes) {
    DecodedImage result;
    JpegReader reader(bytes);
    if (!reader.read_header()) {
        result.problem = fmt::format("cannot be decoded: {}", reader.message());
        return result;
    }
    result.problem = problem_of_size(reader.width, reader.height);
    if (result.problem.empty()) {
        result.problem = reader.problem();
    }
    if (!result.problem.empty()) {
        return result;
    }
    result.image.rgba.resize(4 * reader.width * reader.height);
    if (!reader.read_rows(result.image.rgba.data())) {
        result.problem = fmt::format("cannot be decoded: {}", reader.message());
        result.image = {};
        return result;
    }
    result.damage = reader.damage();
    result.image.width = static_cast<std::uint32_t>(reader.width);
    result.image.height = static_cast<std::uint32_t>(reader.height);
    return result;
}

}  // namespace lanthorn
