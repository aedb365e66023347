#include "engine/image_module/chroma_picture.h"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfMultiPartInputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>

#include <cstddef>

#include "engine/assets/exr_stream.h"
#include "engine/assets/primaries.h"

namespace lanthorn {

bool is_chroma_picture(std::span<const std::uint8_t> bytes) {
    ExrStream stream(bytes);
    const Imf::MultiPartInputFile file(stream, 0, false);
    if (file.parts() != 1) {
        return false;
    }
    const Imf::ChannelList& channels = file.header(0).channels();
    const Imf::Channel* const blue = channels.findChannel("BY");
    return blue != nullptr && channels.findChannel("RY") != nullptr && channels.findChannel("Y") != nullptr &&
           blue->xSampling == 2 && blue->ySampling == 2;
}

WindowedPicture read_chroma_picture(std::span<const std::uint8_t> bytes,
                                    const std::function<bool(const WindowedPicture&)>& wants_pixels) {
    ExrStream stream(bytes);
    Imf::RgbaInputFile file(stream, 0);
    const Imath::Box2i window = file.dataWindow(), full = file.displayWindow();
    WindowedPicture picture;
    picture.x = window.min.x - full.min.x;
    picture.y = window.min.y - full.min.y;
    picture.width = window.max.x - window.min.x + 1;
    picture.height = window.max.y - window.min.y + 1;
    picture.full_width = full.max.x - full.min.x + 1;
    picture.full_height = full.max.y - full.min.y + 1;
    picture.channels = (file.channels() & Imf::WRITE_A) != 0 ? 4 : 3;
    if (!wants_pixels(picture)) {
        return picture;
    }
    const auto width = static_cast<std::size_t>(picture.width);
    std::vector<Imf::Rgba> row(width);
    picture.pixels.reserve(width * static_cast<std::size_t>(picture.height) *
                           static_cast<std::size_t>(picture.channels));
    for (int y = window.min.y; y <= window.max.y; ++y) {
        file.setFrameBuffer(row.data() - window.min.x, 1, 0);
        file.readPixels(y);
        for (const Imf::Rgba& pixel : row) {
            picture.pixels.insert(picture.pixels.end(), {pixel.r, pixel.g, pixel.b});
            if (picture.channels == 4) {
                picture.pixels.push_back(pixel.a);
            }
        }
    }
    if (Imf::hasChromaticities(file.header())) {
        const Imf::Chromaticities& c = Imf::chromaticities(file.header());
        if (const auto matrix = to_bt709(
                {c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y})) {
            multiply(*matrix, picture.pixels, picture.channels);
        }
    }
    return picture;
}

}  // namespace lanthorn
