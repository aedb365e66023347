// EXR files whose colours are luminance and chroma, with fewer pixels of chroma: OpenImageIO 2.4 does not
// read them, OpenEXR does.
#pragma once

#include <cstdint>
#include <span>

#include "engine/image_module/windowed_picture.h"

namespace lanthorn {

// Whether the first part of a file has such channels. Throws what OpenEXR does for damaged files.
bool is_chroma_picture(std::span<const std::uint8_t> bytes);

// Its windows and, unless there is no room for it, its pixels: RGB or RGBA. `fits` sees the windows first and
// throws where they are not read.
WindowedPicture read_chroma_picture(std::span<const std::uint8_t> bytes,
                                    const std::function<bool(const WindowedPicture&)>& wants_pixels);

}  // namespace lanthorn
