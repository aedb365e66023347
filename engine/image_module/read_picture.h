// Image files to pictures, by OpenImageIO.
#pragma once

#include "engine/assets/image_module.h"

namespace lanthorn {

// ImageModule::read.
void read_picture(std::span<const std::uint8_t> bytes, std::string_view format, bool size_only,
                  const PictureLimits& limits, PictureSink& sink);

}  // namespace lanthorn
