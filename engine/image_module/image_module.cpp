// What the module shows to who loads it.
#include "engine/assets/image_module.h"

#include "engine/image_module/read_picture.h"
#include "engine/image_module/write_picture.h"

extern "C" {
__attribute__((visibility("default"))) extern const char lanthorn_image_module_version[];
__attribute__((visibility("default"))) extern const lanthorn::ImageModule lanthorn_image_module;
const char lanthorn_image_module_version[] = LANTHORN_IMAGE_MODULE_VERSION;
const lanthorn::ImageModule lanthorn_image_module = {lanthorn::read_picture, lanthorn::write_picture};
}
