#include "engine/assets/exr_image.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <ImfTileDescriptionAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <vector>

#include "engine/assets/exr_header.h"
#include "engine/assets/image_decode.h"
#include "engine/assets/image_metadata.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::int64_t kLargestRow = 1 << 20;   // bytes; up to 256 are decoded at once
constexpr std::int64_t kLargestTile = 1 << 28;  // bytes; a row of them is held as well
constexpr int kBand = 256;                      // rows; a multiple of what any compression packs together
constexpr std::size_t kSurelyFine = 1u << 26;   // values; beyond it memory grows with what is read

class MemoryIn final : public Imf::IStream {
  public:
    explicit MemoryIn(Bytes bytes) : IStream("memory"), bytes_(bytes) {}
    bool read(char to[], int size) override {
        const auto wanted = static_cast<std::size_t>(size);
        if (size < 0 || at_ > bytes_.size() || wanted > bytes_.size() - at_) {
            throw std::runtime_error("the file is cut off");
        }
        std::memcpy(to, bytes_.data() + at_, wanted);
        at_ += wanted;
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t at) override { at_ = at; }

  private:
    Bytes bytes_;
    std::uint64_t at_ = 0;
};

// R, G, B, then what has another name, then A; some programs write them small.
int rank_of(std::string_view name) {
    switch (name.size() == 1 ? name.front() : 0) {
        case 'R':
        case 'r':
            return 0;
        case 'G':
        case 'g':
            return 1;
        case 'B':
        case 'b':
            return 2;
        case 'A':
        case 'a':
            return 4;
        default:
            return 3;
    }
}

// Those that are read, in the image's order.
std::vector<std::string> chosen_channels(const Imf::ChannelList& channels) {
    std::vector<std::tuple<std::string, int, std::string>> all;  // layer, rank, name
    for (auto i = channels.begin(); i != channels.end(); ++i) {
        const std::string name = i.name();
        const std::size_t dot = name.rfind('.');
        const bool layered = dot != std::string::npos;
        all.emplace_back(layered ? name.substr(0, dot) : "", rank_of(layered ? name.substr(dot + 1) : name),
                         name);
    }
    std::ranges::sort(all);
    const auto has = [&](std::size_t at, int rank) {
        return at < all.size() && std::get<1>(all[at]) == rank;
    };
    const bool rgb = has(0, 0) && has(1, 1) && has(2, 2);
    std::vector<std::string> names;
    for (const auto& [layer, rank, name] : all) {
        if (layer == std::get<0>(all.front()) && (!rgb || rank != 3) && names.size() < 4) {
            names.push_back(name);
        }
    }
    return names;
}

// Why the part is not read; empty if it is.
std::string problem_of(const Imf::Header& header) {
    const Imath::Box2i& window = header.dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (header.hasType() && !Imf::isImage(header.type())) {
        return "is a deep image, expected one with a value a pixel";
    }
    if (width < 1 || height < 1 || width > static_cast<std::int64_t>(kMaxDecodedTexels) / height) {
        return fmt::format("has {} x {} pixels, expected 1 to {}", width, height, kMaxDecodedTexels);
    }
    std::int64_t pixel = 0;  // bytes
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
        pixel += 4;
        if (i.channel().xSampling != 1 || i.channel().ySampling != 1) {
            return "has channels of fewer pixels than others (luminance and chroma), expected one size";
        }
    }
    if (pixel == 0) {
        return "has no channels";
    }
    if (width * pixel > kLargestRow) {
        return fmt::format("has rows of {} bytes, expected at most {}", width * pixel, kLargestRow);
    }
    if (header.hasTileDescription()) {
        const Imf::TileDescription& tile = header.tileDescription();
        if (pixel * tile.ySize > kLargestTile / std::max<std::int64_t>(tile.xSize, width)) {
            return fmt::format("has tiles of {} x {} pixels, which are too large", tile.xSize, tile.ySize);
        }
    }
    return {};
}

void read_pixels(Imf::MultiPartInputFile& file, const Imf::Header& header,
                 const std::vector<std::string>& channels, ImageF& image) {
    Imf::InputPart part(file, 0);
    const Imath::Box2i& window = header.dataWindow();
    int band = kBand;
    if (header.hasTileDescription()) {
        const int tile = static_cast<int>(header.tileDescription().ySize);
        band = (kBand + tile - 1) / tile * tile;
    }
    const std::size_t row = static_cast<std::size_t>(image.width) * channels.size();
    image.pixels.reserve(std::min(row * static_cast<std::size_t>(image.height), kSurelyFine));
    for (int done = 0; done < image.height; done += band) {
        const int rows = std::min(band, image.height - done);
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

ImageF decoded(const std::string& name, Bytes bytes) {
    MemoryIn stream(bytes);
    Imf::MultiPartInputFile file(stream, 0, false);
    const Imf::Header& header = file.header(0);
    if (const std::string problem = problem_of(header); !problem.empty()) {
        throw InputError(name, "", problem);
    }
    if (!file.partComplete(0)) {
        throw InputError(name, "", "cannot be read to its end: it was not written to its end");
    }
    const Imath::Box2i& window = header.dataWindow();
    const std::vector<std::string> channels = chosen_channels(header.channels());
    ImageF image;
    image.width = window.max.x - window.min.x + 1;
    image.height = window.max.y - window.min.y + 1;
    image.channels = static_cast<int>(channels.size());
    read_pixels(file, header, channels, image);
    for (auto i = header.begin(); i != header.end(); ++i) {
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute());
        if (text != nullptr) {
            keep_metadata(image, i.name(), text->value());
        }
    }
    return image;
}

}  // namespace

ImageF read_exr(const std::string& name, Bytes bytes) {
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
