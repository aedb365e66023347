#include "engine/assets/exr_header.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

namespace lanthorn {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kMostParts = 64;  // a table is made for each
constexpr const char* kCutOff = "the file is cut off in its header";
constexpr const char* kDamaged = "its header is damaged";

// Bytes that a value of the type takes, always.
constexpr std::pair<std::string_view, std::size_t> kSizes[] = {{"box2f", 16},
                                                               {"box2i", 16},
                                                               {"chromaticities", 32},
                                                               {"compression", 1},
                                                               {"deepImageState", 1},
                                                               {"double", 8},
                                                               {"envmap", 1},
                                                               {"float", 4},
                                                               {"int", 4},
                                                               {"keycode", 28},
                                                               {"lineOrder", 1},
                                                               {"m33d", 72},
                                                               {"m33f", 36},
                                                               {"m44d", 128},
                                                               {"m44f", 64},
                                                               {"rational", 8},
                                                               {"tiledesc", 9},
                                                               {"timecode", 8},
                                                               {"v2d", 16},
                                                               {"v2f", 8},
                                                               {"v2i", 8},
                                                               {"v3d", 24},
                                                               {"v3f", 12},
                                                               {"v3i", 12}};

// Reads on; what is not there leaves ok() false, and nothing is taken.
class Reader {
  public:
    explicit Reader(Bytes bytes) : rest_(bytes) {}

    bool ok() const { return ok_; }
    bool empty() const { return rest_.empty(); }
    bool at_zero() const { return !rest_.empty() && rest_.front() == 0; }

    Bytes take(std::size_t size) {
        ok_ = ok_ && size <= rest_.size();
        const Bytes taken = ok_ ? rest_.first(size) : Bytes();
        rest_ = ok_ ? rest_.subspan(size) : Bytes();
        return taken;
    }
    // Up to a zero, which is taken too.
    std::string_view text() {
        const auto end = std::ranges::find(rest_, std::uint8_t{0});
        ok_ = ok_ && end != rest_.end();
        const Bytes taken = take(static_cast<std::size_t>(end - rest_.begin()));
        take(1);
        return {reinterpret_cast<const char*>(taken.data()), taken.size()};
    }
    std::size_t number() {
        const Bytes b = take(4);
        return ok_ ? std::size_t{b[0]} | std::size_t{b[1]} << 8 | std::size_t{b[2]} << 16 |
                         std::size_t{b[3]} << 24
                   : 0;
    }

  private:
    Bytes rest_;
    bool ok_ = true;
};

// Names with 16 bytes each, to a zero.
bool is_channel_list(Bytes value) {
    Reader reader(value);
    while (reader.ok() && !reader.empty() && !reader.at_zero()) {
        reader.text();
        reader.take(16);
    }
    reader.take(1);
    return reader.ok() && reader.empty();
}

bool is_list_of_texts(Bytes value) {
    Reader reader(value);
    while (reader.ok() && !reader.empty()) {
        reader.take(reader.number());
    }
    return reader.ok();
}

bool is_preview(Bytes value) {
    Reader reader(value);
    const std::size_t width = reader.number(), height = reader.number();
    return reader.ok() && (width == 0 || height <= value.size() / width) &&
           value.size() == 8 + 4 * width * height;
}

bool is_value(std::string_view type, Bytes value) {
    const auto* const fixed =
        std::ranges::find(kSizes, type, &std::pair<std::string_view, std::size_t>::first);
    if (fixed != std::end(kSizes)) {
        return value.size() == fixed->second;
    }
    if (type == "chlist") {
        return is_channel_list(value);
    }
    if (type == "stringvector") {
        return is_list_of_texts(value);
    }
    if (type == "preview") {
        return is_preview(value);
    }
    return type != "idmanifest";  // packed: what comes of it has no bound
}

}  // namespace

std::string problem_of_exr_headers(Bytes bytes) {
    constexpr std::uint8_t kMultiPart = 0x10;  // of the second byte of the version
    Reader reader(bytes);
    const Bytes beginning = reader.take(8);
    for (std::size_t headers = 0; reader.ok() && !reader.empty();) {
        if (reader.at_zero()) {
            reader.take(1);
            ++headers;
            if ((beginning[5] & kMultiPart) == 0 || reader.at_zero()) {
                return headers <= kMostParts ? "" : "it has more than 64 parts";
            }
            continue;
        }
        reader.text();
        const std::string_view type = reader.text();
        const Bytes value = reader.take(reader.number());
        if (reader.ok() && !is_value(type, value)) {
            return kDamaged;
        }
    }
    return kCutOff;
}

}  // namespace lanthorn
