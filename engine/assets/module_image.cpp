#include "engine/assets/module_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <functional>

#include "engine/assets/exr_header.h"
#include "engine/assets/image_decode.h"
#include "engine/assets/image_metadata.h"
#include "engine/assets/image_module_file.h"
#include "engine/assets/work_apart.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/printable.h"

namespace lanthorn {

namespace {

constexpr PictureLimits kLimits = {kMaxDecodedTexels, 256, 4096};
constexpr double kPixelsASecond = 1e6;  // slower is not waited for
constexpr std::uint64_t kBytesAPixel =
    4 * 4 * 4;  // the file's, the window's and the turned picture, and what is between
constexpr std::size_t kLargestText = 1u << 16;  // of one that is kept

enum Record : std::uint8_t { kSize, kText, kValues, kBytes, kProblem };

struct Size {
    int width, height, channels;
    bool linear;
};

// In the copy: sends what the module makes.
class SendingSink final : public PictureSink {
  public:
    explicit SendingSink(Sender& sender) : sender_(sender) {}
    void size(int width, int height, int channels, bool linear) override {
        const Size size = {width, height, channels, linear};
        sender_.send(kSize, std::as_bytes(std::span(&size, 1)));
        const std::uint64_t pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
        Sender::allow(kWorkSeconds + static_cast<double>(pixels) / kPixelsASecond,
                      kWorkBytes + pixels * kBytesAPixel);
    }
    void text(std::string_view key, std::string_view value) override {
        if (key.size() + value.size() < kLargestText) {
            const std::string both = std::string(key) + '\0' + std::string(value);
            sender_.send(kText, std::as_bytes(std::span(both)));
        }
    }
    void values(std::span<const float> values) override { send_parts(kValues, std::as_bytes(values)); }
    void bytes(std::span<const std::uint8_t> bytes) override { send_parts(kBytes, std::as_bytes(bytes)); }
    void problem(std::string_view line) override {
        sender_.send(kProblem, std::as_bytes(std::span(line.substr(0, 1000))));
    }

  private:
    void send_parts(Record kind, std::span<const std::byte> all) {
        for (std::size_t at = 0; at < all.size(); at += kLargestRecord) {
            sender_.send(kind, all.subspan(at, std::min(kLargestRecord, all.size() - at)));
        }
    }
    Sender& sender_;
};

// On this side: believes nothing that the copy sends, whose memory a damaged file may have overwritten.
class Received {
  public:
    bool take(std::uint8_t kind, std::span<const std::byte> record) {
        const std::string_view text(reinterpret_cast<const char*>(record.data()), record.size());
        switch (kind) {
            case kSize:
                return take_size(record);
            case kText:
                keep_metadata(image, text.substr(0, text.find('\0')),
                              text.substr(std::min(text.find('\0') + 1, text.size())));
                return true;
            case kValues:
                return take_values(record);
            case kBytes:
                bytes += text;
                return true;
            default:
                problem = printable(first_line(std::string(text)));
                return true;
        }
    }
    bool whole() const { return has_size_ && image.pixels.size() == values_; }
    bool has_size() const { return has_size_; }

    ImageF image;
    std::string bytes, problem;

  private:
    bool take_size(std::span<const std::byte> record) {
        Size size = {};
        if (record.size() != sizeof size) {
            return false;
        }
        std::memcpy(&size, record.data(), sizeof size);
        if (size.width < 1 || size.height < 1 || size.channels < 1 || size.channels > 4 ||
            !problem_of_size(static_cast<std::uint64_t>(size.width), static_cast<std::uint64_t>(size.height))
                 .empty()) {
            return false;
        }
        image.width = size.width;
        image.height = size.height;
        image.channels = size.channels;
        image.linear = size.linear;
        values_ = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
                  static_cast<std::size_t>(size.channels);
        has_size_ = true;
        return true;
    }
    bool take_values(std::span<const std::byte> record) {
        const std::size_t count = record.size() / sizeof(float), at = image.pixels.size();
        if (!has_size_ || count > values_ - at) {
            return false;
        }
        image.pixels.resize(at + count);
        std::memcpy(image.pixels.data() + at, record.data(), count * sizeof(float));
        return true;
    }
    std::size_t values_ = 0;
    bool has_size_ = false;
};

using Work = std::function<void(const ImageModule& module, PictureSink& sink)>;

// Why it did not come to its end, in Received::problem.
Received run(const Work& work) {
    Received received;
    const ImageModule* module = image_module(received.problem);
    if (module == nullptr) {
        return received;
    }
    const std::string broken = work_apart(
        [&](Sender& sender) {
            SendingSink sink(sender);
            work(*module, sink);
        },
        [&](std::uint8_t kind, std::span<const std::byte> record) { return received.take(kind, record); });
    if (received.problem.empty() && !broken.empty()) {
        received.problem = broken;
    }
    return received;
}

Received read(std::span<const std::uint8_t> bytes, std::string_view format, bool size_only) {
    Received received;
    if (format == "openexr") {
        received.problem = problem_of_exr_headers(bytes);
    }
    if (!received.problem.empty()) {
        received.problem = "cannot be read as an image: " + received.problem;
        return received;
    }
    return run([&](const ImageModule& module, PictureSink& sink) {
        module.read(bytes, format, size_only, kLimits, sink);
    });
}

}  // namespace

ImageF read_by_module(const std::string& name, std::span<const std::uint8_t> bytes, std::string_view format) {
    Received received = read(bytes, format, false);
    if (received.problem.empty() && !received.whole()) {
        received.problem = "cannot be read to its end";
    }
    if (!received.problem.empty()) {
        throw InputError(name, "", received.problem);
    }
    return std::move(received.image);
}

std::uint64_t size_by_module(std::span<const std::uint8_t> bytes, std::string_view format) {
    const Received received = read(bytes, format, true);
    return received.problem.empty() && received.has_size()
               ? static_cast<std::uint64_t>(received.image.width) *
                     static_cast<std::uint64_t>(received.image.height)
               : 0;
}

std::string bytes_by_module(const std::string& name, const ImageF& image, std::string_view format,
                            bool linear) {
    Received received = run([&](const ImageModule& module, PictureSink& sink) {
        Sender::allow(kWorkSeconds + static_cast<double>(image.pixels.size()) / kPixelsASecond,
                      kWorkBytes + 4 * image.pixels.size() * sizeof(float));
        module.write(image, format, linear, sink);
    });
    if (received.problem.empty() && received.bytes.empty()) {
        received.problem = "cannot be written";
    }
    if (!received.problem.empty()) {
        throw InputError(name, "", received.problem);
    }
    return std::move(received.bytes);
}

}  // namespace lanthorn
