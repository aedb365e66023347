// Pictures to image files, by OpenImageIO.
#pragma once

#include "engine/assets/image_module.h"

namespace lanthorn {

// ImageModule::write.
void write_picture(const ImageF& image, std::string_view format, bool linear, PictureSink& sink);

}  // namespace lanthorn
