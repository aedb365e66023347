#include "engine/assets/exr_image.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <string_view>
#include <vector>

#include "engine/assets/exr_channels.h"
#include "engine/assets/exr_header.h"
#include "engine/assets/exr_stream.h"
#include "engine/assets/image_decode.h"
#include "engine/assets/image_metadata.h"
#include "engine/assets/primaries.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::int64_t kLargestRow = 1 << 20;  // bytes; up to 256 are decoded at once
constexpr int kBand = 256;                     // rows; a multiple of what any compression packs together
constexpr std::size_t kSurelyFine = 1u << 26;  // values; beyond it memory grows with what is read

std::vector<std::string> names_of(const Imf::ChannelList& channels) {
    std::vector<std::string> all, names;
    for (auto i = channels.begin(); i != channels.end(); ++i) {
        all.emplace_back(i.name());
    }
    for (const std::size_t place : chosen_channels(all)) {
        names.push_back(all[place]);
    }
    return names;
}

// One part of scan lines that fill its display window, every channel of its size.
bool is_plain(const Imf::MultiPartInputFile& file) {
    const Imf::Header& header = file.header(0);
    bool plain = file.parts() == 1 && !header.hasTileDescription() &&
                 header.dataWindow() == header.displayWindow() &&
                 !(header.hasType() && !Imf::isImage(header.type()));
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
        plain = plain && i.channel().xSampling == 1 && i.channel().ySampling == 1;
    }
    return plain;
}

// Why the part is not read; empty if it is.
std::string problem_of(const Imf::Header& header) {
    const Imath::Box2i& window = header.dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width > static_cast<std::int64_t>(kMaxDecodedTexels) / height) {
        return fmt::format("has {} x {} pixels, expected 1 to {}", width, height, kMaxDecodedTexels);
    }
    std::int64_t pixel = 0;  // bytes
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
        pixel += 4;
    }
    if (pixel == 0) {
        return "has no channels";
    }
    if (width * pixel > kLargestRow) {
        return fmt::format("has rows of {} bytes, expected at most {}", width * pixel, kLargestRow);
    }
    return {};
}

void read_pixels(Imf::MultiPartInputFile& file, const Imf::Header& header,
                 const std::vector<std::string>& channels, ImageF& image) {
    Imf::InputPart part(file, 0);
    const Imath::Box2i& window = header.dataWindow();
    const std::size_t row = static_cast<std::size_t>(image.width) * channels.size();
    image.pixels.reserve(std::min(row * static_cast<std::size_t>(image.height), kSurelyFine));
    for (int done = 0; done < image.height; done += kBand) {
        const int rows = std::min(kBand, image.height - done);
        const std::size_t at = image.pixels.size();
        image.pixels.resize(at + row * static_cast<std::size_t>(rows));
        const Imath::V2i corner(window.min.x, window.min.y + done);
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < channels.size(); ++c) {
            frame.insert(channels[c],
                         Imf::Slice::Make(Imf::FLOAT, &image.pixels[at + c], corner, image.width, rows,
                                          channels.size() * sizeof(float), row * sizeof(float)));
        }
        part.setFrameBuffer(frame);
        part.readPixels(corner.y, corner.y + rows - 1);
    }
}

std::optional<ImageF> decoded(const std::string& name, Bytes bytes) {
    ExrStream stream(bytes);
    Imf::MultiPartInputFile file(stream, 0, false);
    if (!is_plain(file)) {
        return std::nullopt;
    }
    const Imf::Header& header = file.header(0);
    if (const std::string problem = problem_of(header); !problem.empty()) {
        throw InputError(name, "", problem);
    }
    if (!file.partComplete(0)) {
        throw InputError(name, "", "cannot be read to its end: it was not written to its end");
    }
    const Imath::Box2i& window = header.dataWindow();
    const std::vector<std::string> channels = names_of(header.channels());
    ImageF image;
    image.width = window.max.x - window.min.x + 1;
    image.height = window.max.y - window.min.y + 1;
    image.channels = static_cast<int>(channels.size());
    image.linear = true;
    read_pixels(file, header, channels, image);
    if (Imf::hasChromaticities(header) && are_colours(channels)) {
        const Imf::Chromaticities& c = Imf::chromaticities(header);
        if (const auto matrix = to_bt709(
                {c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y})) {
            multiply(*matrix, image.pixels, image.channels);
        }
    }
    for (auto i = header.begin(); i != header.end(); ++i) {
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute());
        if (text != nullptr) {
            keep_metadata(image, i.name(), text->value());
        }
    }
    return image;
}

}  // namespace

std::optional<ImageF> read_plain_exr(const std::string& name, Bytes bytes) {
    if (const std::string problem = problem_of_exr_headers(bytes); !problem.empty()) {
        throw InputError(name, "", "cannot be read as an image: " + problem);
    }
    try {
        return decoded(name, bytes);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(name, "", fmt::format("cannot be read as an image: {}", first_line(error.what())));
    }
}

std::string exr_bytes(const ImageF& image) {
    constexpr std::array<std::array<const char*, 4>, 4> kNames = {
        {{"Y"}, {"R", "G"}, {"R", "G", "B"}, {"R", "G", "B", "A"}}};
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [key, value] : image.metadata) {
        header.insert(metadata_name(key), Imf::StringAttribute(value));
    }
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t row = channels * static_cast<std::size_t>(image.width) * sizeof(float);
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < channels; ++c) {
        const char* name = kNames[channels - 1][c];
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        frame.insert(name, Imf::Slice::Make(Imf::FLOAT, &image.pixels[c], Imath::V2i(0), image.width,
                                            image.height, channels * sizeof(float), row));
    }
    Imf::StdOSStream stream;
    {
        Imf::OutputFile file(stream, header, 0);
        file.setFrameBuffer(frame);
        file.writePixels(image.height);
    }  // writes the table of its parts
    return stream.str();
}

}  // namespace lanthorn
