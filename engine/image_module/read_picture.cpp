#include "engine/image_module/read_picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/assets/exr_channels.h"
#include "engine/assets/primaries.h"
#include "engine/image_module/chroma_picture.h"
#include "engine/image_module/orientation.h"
#include "engine/image_module/radiance_header.h"
#include "engine/image_module/windowed_picture.h"

namespace lanthorn {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint64_t kSurelyFine = 1u << 24;  // pixels, however few the bytes
constexpr int kMostTexts = 1000;

// The reader's own limits: they hold before it has told the size.
void set_limits(const PictureLimits& limits) {
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
    OIIO::attribute("limits:channels", limits.channels);
    OIIO::attribute("limits:imagesize_MB", static_cast<int>(limits.pixels * 16 >> 20));
}

// A file of OpenImageIO's, read from memory, or through a file without a name where its reader wants a
// file's.
class PictureFile {
  public:
    PictureFile(Bytes bytes, const std::string& format) : memory_(bytes.data(), bytes.size()) {
        input_ = OIIO::ImageInput::create(format);
        if (!input_) {
            throw std::runtime_error(
                fmt::format("is of the format {}, which this OpenImageIO has not", format));
        }
        OIIO::ImageSpec wishes;
        wishes.attribute("oiio:UnassociatedAlpha", 1);
        bool opened = false;
        if (input_->supports("ioproxy")) {
            opened = input_->set_ioproxy(&memory_) && input_->open("memory." + format, spec_, wishes);
        } else {
            opened = input_->open(file_of(bytes), spec_, wishes);
        }
        if (!opened) {
            throw std::runtime_error("cannot be read as an image: " + reason());
        }
        if (spec_.deep) {
            throw std::runtime_error("is a deep image, expected one with a value a pixel");
        }
    }

    const OIIO::ImageSpec& spec() const { return spec_; }

    // Values of all channels between the first and the last of `channels`, of which those are kept.
    std::vector<float> read(const std::vector<std::size_t>& channels) {
        const auto [first, last] = std::ranges::minmax(channels);
        const std::size_t count = last - first + 1;
        std::vector<float> all(static_cast<std::size_t>(spec_.width) *
                               static_cast<std::size_t>(spec_.height) * count);
        if (!input_->read_image(0, 0, static_cast<int>(first), static_cast<int>(last) + 1,
                                OIIO::TypeDesc::FLOAT, all.data())) {
            throw std::runtime_error("cannot be read to its end: " + reason());
        }
        std::vector<float> kept(all.size() / count * channels.size());
        for (std::size_t pixel = 0; pixel < all.size() / count; ++pixel) {
            for (std::size_t c = 0; c < channels.size(); ++c) {
                kept[pixel * channels.size() + c] = all[pixel * count + channels[c] - first];
            }
        }
        return kept;
    }

  private:
    std::string reason() const {
        const std::string said = input_->geterror();
        return said.find_first_not_of(" \n") == std::string::npos ? "it is damaged" : said;
    }
    std::string file_of(Bytes bytes) {
        const int file = ::memfd_create("picture", MFD_CLOEXEC);  // closed with the process
        for (std::size_t at = 0; at < bytes.size();) {
            const ssize_t written = ::write(file, bytes.data() + at, bytes.size() - at);
            if (written <= 0) {
                throw std::runtime_error("cannot be read as an image: no room for it");
            }
            at += static_cast<std::size_t>(written);
        }
        return fmt::format("/proc/self/fd/{}", file);
    }

    OIIO::Filesystem::IOMemReader memory_;
    std::unique_ptr<OIIO::ImageInput> input_;
    OIIO::ImageSpec spec_;
};

WindowedPicture windows_of(const OIIO::ImageSpec& spec, const std::string& format) {
    WindowedPicture picture;
    picture.width = picture.full_width = spec.width;
    picture.height = picture.full_height = spec.height;
    if (format == "openexr") {  // of other formats the place is where it lies on a page
        picture.x = spec.x - spec.full_x;
        picture.y = spec.y - spec.full_y;
        picture.full_width = spec.full_width;
        picture.full_height = spec.full_height;
    }
    return picture;
}

void check_size(const WindowedPicture& picture, Bytes bytes, const PictureLimits& limits) {
    for (const auto& [width, height] :
         {std::pair(picture.width, picture.height), std::pair(picture.full_width, picture.full_height)}) {
        if (width < 1 || height < 1 ||
            static_cast<std::uint64_t>(width) > limits.pixels / static_cast<std::uint64_t>(height)) {
            throw std::runtime_error(
                fmt::format("has {} x {} pixels, expected 1 to {}", width, height, limits.pixels));
        }
        const std::uint64_t pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
        if (pixels > kSurelyFine && (pixels - kSurelyFine) / limits.most_a_byte > bytes.size()) {
            throw std::runtime_error(
                fmt::format("has {} x {} pixels in {} bytes, more than are taken from so few", width, height,
                            bytes.size()));
        }
    }
}

// To radiance, in BT.709.
void restore_radiance(std::vector<float>& pixels, const RadianceHeader& header) {
    for (float& value : pixels) {
        value *= header.scale;
    }
    if (header.colours) {
        multiply(*header.colours, pixels, 3);
    }
}

// Of an EXR that says which primaries its colours have.
void restore_primaries(WindowedPicture& picture, const OIIO::ImageSpec& spec,
                       const std::vector<std::size_t>& channels) {
    std::vector<std::string> names;
    names.reserve(channels.size());
    for (const std::size_t channel : channels) {
        names.push_back(spec.channelnames[channel]);
    }
    Chromaticities given = {};
    std::array<float, 8> stated = {};
    if (are_colours(names) &&
        spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), stated.data())) {
        std::ranges::copy(stated, given.begin());
        if (const auto matrix = to_bt709(given)) {
            multiply(*matrix, picture.pixels, picture.channels);
        }
    }
}

// OpenImageIO makes whole numbers 0..1; those of an EXR are numbers of things.
void restore_whole_numbers(WindowedPicture& picture, const OIIO::ImageSpec& spec,
                           const std::vector<std::size_t>& channels) {
    constexpr double kLargest = 4294967295.0;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        if (spec.channelformat(static_cast<int>(channels[c])) == OIIO::TypeDesc::UINT) {
            for (std::size_t at = c; at < picture.pixels.size(); at += channels.size()) {
                picture.pixels[at] = static_cast<float>(std::round(picture.pixels[at] * kLargest));
            }
        }
    }
}

// A TIFF says of its alpha whether it is multiplied in.
void divide_by_alpha(WindowedPicture& picture, const OIIO::ImageSpec& spec, const std::string& format) {
    if (format != "tiff" || picture.channels != 4 || spec.alpha_channel < 0 ||
        spec.get_int_attribute("oiio:UnassociatedAlpha") != 0) {
        return;
    }
    for (std::size_t at = 0; at < picture.pixels.size(); at += 4) {
        const float alpha = picture.pixels[at + 3];
        for (std::size_t c = 0; c < 3 && alpha > 0; ++c) {
            picture.pixels[at + c] /= alpha;
        }
    }
}

void send_pixels(WindowedPicture picture, int orientation, bool linear, PictureSink& sink) {
    int width = picture.full_width, height = picture.full_height;
    const int channels = picture.channels;
    const std::vector<float> upright =
        turned_upright(whole_of(std::move(picture)), width, height, channels, orientation);
    sink.size(width, height, channels, linear);
    sink.values(upright);
}

void read_chroma(Bytes bytes, bool size_only, const PictureLimits& limits, PictureSink& sink) {
    WindowedPicture picture = read_chroma_picture(bytes, [&](const WindowedPicture& windows) {
        check_size(windows, bytes, limits);
        sink.size(windows.full_width, windows.full_height, windows.channels, true);
        return !size_only;
    });
    if (!size_only) {
        send_pixels(std::move(picture), 1, true, sink);
    }
}

void read(Bytes bytes, const std::string& format, bool size_only, const PictureLimits& limits,
          PictureSink& sink) {
    set_limits(limits);
    if (format == "openexr" && is_chroma_picture(bytes)) {
        read_chroma(bytes, size_only, limits, sink);
        return;
    }
    const RadianceHeader radiance = format == "hdr" ? radiance_header(bytes) : RadianceHeader();
    const std::string as_rgb = radiance.is_xyz ? named_rgb(bytes) : "";
    PictureFile file(
        radiance.is_xyz ? Bytes(reinterpret_cast<const std::uint8_t*>(as_rgb.data()), as_rgb.size()) : bytes,
        format);
    const OIIO::ImageSpec& spec = file.spec();
    if (spec.nchannels < 1 || spec.nchannels > limits.channels || spec.depth > 1) {
        throw std::runtime_error(
            fmt::format("has {} channels and {} layers of depth, expected 1 to {} and one", spec.nchannels,
                        spec.depth, limits.channels));
    }
    std::vector<std::size_t> channels = chosen_channels(spec.channelnames);
    if (channels.empty()) {
        throw std::runtime_error("has no channels that have names");
    }
    WindowedPicture picture = windows_of(spec, format);
    check_size(picture, bytes, limits);
    picture.channels = static_cast<int>(channels.size());
    const bool linear = spec.format.is_floating_point();
    sink.size(picture.full_width, picture.full_height, picture.channels, linear);
    if (size_only) {
        return;
    }
    int texts = 0;
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        if (attribute.type() == OIIO::TypeDesc::STRING && ++texts < kMostTexts) {
            sink.text(attribute.name().string(), attribute.get_string());
        }
    }
    picture.pixels = file.read(channels);
    if (format == "hdr") {
        restore_radiance(picture.pixels, radiance);
    } else if (format == "openexr") {
        restore_whole_numbers(picture, spec, channels);
        restore_primaries(picture, spec, channels);
    }
    divide_by_alpha(picture, spec, format);
    const int orientation =
        format == "hdr" ? radiance_orientation(bytes) : spec.get_int_attribute("Orientation", 1);
    send_pixels(std::move(picture), orientation, linear, sink);
}

}  // namespace

void read_picture(Bytes bytes, std::string_view format, bool size_only, const PictureLimits& limits,
                  PictureSink& sink) {
    try {
        read(bytes, std::string(format), size_only, limits, sink);
    } catch (const std::bad_alloc&) {
        sink.problem("needs more memory than a picture of its size");
    } catch (const std::exception& error) {
        sink.problem(error.what());
    }
}

}  // namespace lanthorn
