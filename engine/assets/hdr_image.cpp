#include "engine/assets/hdr_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "engine/assets/image_decode.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/printable.h"

namespace lanthorn {

namespace {

constexpr std::size_t kShortestPlanes = 8, kLongestPlanes = 32767;  // pixels of a row in runs of planes
constexpr std::size_t kLongestRun = 127, kShortestRun = 4;          // bytes; a shorter one gains nothing
constexpr std::size_t kSurelyFine = 1u << 24;                       // pixels
// Of rows in runs of planes at most 127 / 8, of a run of pixels 255 / 4. Runs that continue another have no
// bound.
constexpr std::uint64_t kMostPixelsAByte = 64;

using Pixel = std::array<std::uint8_t, 4>;  // red, green, blue, exponent

// --- reading

std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view kBlanks = " \t";
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

class HdrReader {
  public:
    HdrReader(const std::string& name, std::span<const std::uint8_t> bytes) : name_(name), rest_(bytes) {}

    ImageF read() {
        read_header();
        read_size();
        pixels_.reserve(std::min(row_length_ * rows_, kSurelyFine));
        for (std::size_t row = 0; row < rows_; ++row) {
            read_row();
        }
        return turned();
    }

  private:
    [[noreturn]] void refuse(const std::string& problem) const { throw InputError(name_, "", problem); }
    [[noreturn]] void refuse_cut() const {
        refuse(fmt::format("cannot be read to its end: the file is cut off in row {}",
                           pixels_.size() / row_length_));
    }

    // Without its end.
    std::string_view take_line() {
        constexpr std::size_t kLongest = 4096;
        const std::string_view text(reinterpret_cast<const char*>(rest_.data()),
                                    std::min(rest_.size(), kLongest));
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) {
            refuse("cannot be read as an image: its header has no end");
        }
        rest_ = rest_.subspan(end + 1);
        const std::string_view line = text.substr(0, end);
        return line.substr(0, line.size() - (line.ends_with('\r') ? 1 : 0));
    }

    void read_header() {
        constexpr std::string_view kFormat = "FORMAT=";
        for (std::string_view line = take_line(); !line.empty(); line = take_line()) {
            if (line.starts_with(kFormat) &&
                without_blanks(line.substr(kFormat.size())) != "32-bit_rle_rgbe") {
                refuse(
                    fmt::format("found {}, expected FORMAT=32-bit_rle_rgbe", printable(shortened(line, 60))));
            }
        }
    }

    // "-Y 480 +X 640": rows from the top, 480 of them, each from the left, of 640 pixels.
    void read_size() {
        const std::string_view line = without_blanks(take_line());
        std::size_t at = 0;
        const auto take_axis = [&](char& sign, char& axis, std::size_t& length) {
            if (line.size() < at + 4 || line[at + 2] != ' ') {
                return false;
            }
            sign = line[at];
            axis = line[at + 1];
            const auto [end, error] =
                std::from_chars(line.data() + at + 3, line.data() + line.size(), length);
            at = static_cast<std::size_t>(end - line.data());
            return error == std::errc() && (sign == '+' || sign == '-') && (axis == 'X' || axis == 'Y');
        };
        char row_sign = 0, row_axis = 0, sign = 0, axis = 0;
        if (!take_axis(row_sign, row_axis, rows_) || !line.substr(at++).starts_with(' ') ||
            !take_axis(sign, axis, row_length_) || row_axis == axis || at < line.size()) {
            refuse(fmt::format("found the size '{}', expected one as '-Y 480 +X 640'",
                               printable(shortened(line, 60))));
        }
        upright_ = row_axis == 'Y';
        from_top_ = (upright_ ? row_sign : sign) == '-';
        from_left_ = (upright_ ? sign : row_sign) == '+';
        std::string problem = problem_of_size(row_length_, rows_);
        if (problem.empty()) {
            problem = problem_of_packing(row_length_, rows_, rest_.size(), kMostPixelsAByte);
        }
        if (!problem.empty()) {
            refuse(problem);
        }
    }

    Pixel take_pixel() {
        if (rest_.size() < 4) {
            refuse_cut();
        }
        const Pixel pixel = {rest_[0], rest_[1], rest_[2], rest_[3]};
        rest_ = rest_.subspan(4);
        return pixel;
    }

    void read_row() {
        const std::size_t end = pixels_.size() + row_length_;
        if (row_length_ >= kShortestPlanes && row_length_ <= kLongestPlanes && rest_.size() >= 4 &&
            rest_[0] == 2 && rest_[1] == 2 && (rest_[2] & 128) == 0) {
            const Pixel head = take_pixel();
            if (static_cast<std::size_t>(head[2] << 8 | head[3]) != row_length_) {
                refuse(fmt::format("cannot be read to its end: row {} is of {} pixels, expected {}",
                                   pixels_.size() / row_length_, head[2] << 8 | head[3], row_length_));
            }
            pixels_.resize(end);
            for (std::size_t plane = 0; plane < 4; ++plane) {
                read_plane(end - row_length_, plane);
            }
            return;
        }
        for (unsigned shift = 0; pixels_.size() < end;) {
            const Pixel pixel = take_pixel();
            if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
                pixels_.push_back(pixel);
                shift = 0;
                continue;
            }
            // So many times the pixel before; the next such count is of 256 times as many.
            const std::size_t count = shift < 32 ? std::size_t{pixel[3]} << shift : row_length_ + 1;
            if (count > end - pixels_.size() || pixels_.empty()) {
                refuse(fmt::format("cannot be read to its end: a run is longer than row {}",
                                   pixels_.size() / row_length_));
            }
            pixels_.insert(pixels_.end(), count, Pixel(pixels_.back()));
            shift += 8;
        }
    }

    // One byte of each pixel of the row that begins at `begin`.
    void read_plane(std::size_t begin, std::size_t plane) {
        const auto take = [this, begin] {
            if (rest_.empty()) {
                pixels_.resize(begin);
                refuse_cut();
            }
            const std::uint8_t byte = rest_.front();
            rest_ = rest_.subspan(1);
            return byte;
        };
        for (std::size_t x = 0; x < row_length_;) {
            const std::uint8_t head = take();
            const bool run = head > 128;
            const std::size_t count = run ? head - 128u : head;
            if (count == 0 || count > row_length_ - x) {
                refuse(fmt::format("cannot be read to its end: a run is longer than row {}",
                                   begin / row_length_));
            }
            std::uint8_t value = run ? take() : 0;
            for (const std::size_t to = x + count; x < to; ++x) {
                value = run ? value : take();
                pixels_[begin + x][plane] = value;
            }
        }
    }

    // Rows from the top, each from the left.
    ImageF turned() const {
        ImageF image;
        image.width = static_cast<int>(upright_ ? row_length_ : rows_);
        image.height = static_cast<int>(upright_ ? rows_ : row_length_);
        image.channels = 3;
        image.pixels.resize(3 * pixels_.size());
        for (int y = 0; y < image.height; ++y) {
            const auto v = static_cast<std::size_t>(from_top_ ? y : image.height - 1 - y);
            for (int x = 0; x < image.width; ++x) {
                const auto u = static_cast<std::size_t>(from_left_ ? x : image.width - 1 - x);
                const Pixel& pixel = pixels_[upright_ ? v * row_length_ + u : u * row_length_ + v];
                const float scale = pixel[3] > 0 ? std::ldexp(1.0f, pixel[3] - (128 + 8)) : 0.0f;
                for (int c = 0; c < 3; ++c) {
                    image.at(x, y, c) = static_cast<float>(pixel[static_cast<std::size_t>(c)]) * scale;
                }
            }
        }
        return image;
    }

    const std::string& name_;
    std::span<const std::uint8_t> rest_;
    std::size_t rows_ = 0, row_length_ = 0;
    bool upright_ = true, from_top_ = true, from_left_ = true;
    std::vector<Pixel> pixels_;
};

// --- writing

Pixel pixel_of(const float* colour) {
    std::array<float, 3> limited;
    for (std::size_t c = 0; c < 3; ++c) {
        limited[c] = colour[c] > 0 ? std::min(colour[c], 0x1.fep126f) : 0.0f;  // NaN becomes 0
    }
    int exponent = 0;
    std::frexp(*std::ranges::max_element(limited), &exponent);
    // A mantissa that rounds up to 256 needs the next exponent.
    for (;; ++exponent) {
        Pixel pixel;
        bool fits = true;
        for (std::size_t c = 0; c < 3; ++c) {
            const long rounded = std::lround(std::ldexp(limited[c], 8 - exponent));
            fits = fits && rounded < 256;
            pixel[c] = static_cast<std::uint8_t>(rounded);
        }
        if (fits) {
            pixel[3] = static_cast<std::uint8_t>(std::max(exponent + 128, 0));
            const bool black = exponent + 128 < 1 || (pixel[0] == 0 && pixel[1] == 0 && pixel[2] == 0);
            return black ? Pixel{} : pixel;
        }
    }
}

// How many pixels from `x` on have the same byte.
std::size_t run_at(const std::vector<Pixel>& row, std::size_t plane, std::size_t x) {
    const std::size_t limit = std::min(row.size() - x, kLongestRun);
    std::size_t length = 1;
    while (length < limit && row[x + length][plane] == row[x][plane]) {
        ++length;
    }
    return length;
}

void append_plane(std::string& out, const std::vector<Pixel>& row, std::size_t plane) {
    for (std::size_t x = 0; x < row.size();) {
        const std::size_t begin = x;
        std::size_t run = run_at(row, plane, x);
        while (run < kShortestRun && x < row.size()) {  // what comes before the next run that is worth it
            x += run;
            run = x < row.size() ? run_at(row, plane, x) : 0;
        }
        for (std::size_t at = begin; at < x;) {
            const std::size_t count = std::min(x - at, kLongestRun + 1);
            out.push_back(static_cast<char>(count));
            for (const std::size_t to = at + count; at < to; ++at) {
                out.push_back(static_cast<char>(row[at][plane]));
            }
        }
        if (run >= kShortestRun) {
            out.push_back(static_cast<char>(128 + run));
            out.push_back(static_cast<char>(row[x][plane]));
            x += run;
        }
    }
}

}  // namespace

ImageF read_hdr(const std::string& name, std::span<const std::uint8_t> bytes) {
    return HdrReader(name, bytes).read();
}

std::string hdr_bytes(const ImageF& image) {
    std::string out =
        fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.height, image.width);
    std::vector<Pixel> row(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        for (std::size_t x = 0; x < row.size(); ++x) {
            row[x] = pixel_of(&image.pixels[3 * (static_cast<std::size_t>(y) * row.size() + x)]);
        }
        if (row.size() < kShortestPlanes || row.size() > kLongestPlanes) {
            for (const Pixel& pixel : row) {
                out.append(pixel.begin(), pixel.end());
            }
            continue;
        }
        out += {2, 2, static_cast<char>(row.size() >> 8), static_cast<char>(row.size())};
        for (std::size_t plane = 0; plane < 4; ++plane) {
            append_plane(out, row, plane);
        }
    }
    return out;
}

}  // namespace lanthorn
