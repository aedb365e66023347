// What the image module and who loads it agree on. The module is the one library that links OpenImageIO, and
// with it some 260 others: it is loaded when the first image needs it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "lanthorn/core/image.h"

namespace lanthorn {

// Takes what the module makes, in this order: size, texts, values; or bytes; or a problem alone.
class PictureSink {
  public:
    virtual ~PictureSink() = default;
    // channels: 1 to 4. linear: the file holds floating-point numbers.
    virtual void size(int width, int height, int channels, bool linear) = 0;
    virtual void text(std::string_view key, std::string_view value) = 0;
    virtual void values(std::span<const float> values) = 0;
    virtual void bytes(std::span<const std::uint8_t> bytes) = 0;
    virtual void problem(std::string_view line) = 0;
};

// What is not read or made; the sink's other end takes no more either.
struct PictureLimits {
    std::uint64_t pixels;       // of the picture
    int channels;               // of the file
    std::uint64_t most_a_byte;  // pixels for each byte of the file, beyond 4096 x 4096
};

// The module's only symbol but for its version. Nothing is thrown through it.
struct ImageModule {
    // `format` is OpenImageIO's name of it. size_only: no more than the size.
    void (*read)(std::span<const std::uint8_t> bytes, std::string_view format, bool size_only,
                 const PictureLimits& limits, PictureSink& sink);
    void (*write)(const ImageF& image, std::string_view format, bool linear, PictureSink& sink);
};

inline constexpr const char* kImageModuleVersionSymbol = "lanthorn_image_module_version";  // const char[]
inline constexpr const char* kImageModuleSymbol = "lanthorn_image_module";  // const ImageModule

// Of a module that this program can use: the project's version and the interface's.
#define LANTHORN_IMAGE_MODULE_VERSION LANTHORN_VERSION "-1"

}  // namespace lanthorn
