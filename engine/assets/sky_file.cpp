#include "lanthorn/assets/sky_file.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

constexpr int kLargest = 8192;  // 0.4 GB, and as much again without its suns

SkyImage sky_image(const std::filesystem::path& path) {
    const ImageF image = read_image(path);
    const std::string name = path.string();
    if (image.width > kLargest || image.height > kLargest / 2 || image.width < image.height ||
        image.width > 4 * image.height) {
        throw InputError(
            name, "",
            fmt::format("found {} x {} pixels, expected an equirectangular image: about twice as "
                        "wide as high, at most {} x {}",
                        image.width, image.height, kLargest, kLargest / 2));
    }
    const bool encoded = path.extension() == ".png" || path.extension() == ".PNG";
    SkyImage sky;
    sky.name = path.filename().string();
    sky.width = static_cast<std::uint32_t>(image.width);
    sky.height = static_cast<std::uint32_t>(image.height);
    sky.radiance.reserve(std::size_t{sky.width} * sky.height);
    const bool grey = image.channels < 3;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            vec3 c(image.at(x, y, 0), image.at(x, y, grey ? 0 : 1), image.at(x, y, grey ? 0 : 2));
            for (int i = 0; i < 3; ++i) {
                c[i] = encoded ? linear_from_srgb(c[i]) : c[i];
                if (!(c[i] >= 0) || !std::isfinite(c[i])) {
                    throw InputError(name, fmt::format("pixel {},{}", x, y),
                                     fmt::format("found {}, expected a finite number >= 0", c[i]));
                }
            }
            sky.radiance.push_back(c);
        }
    }
    return sky;
}

}  // namespace

Sky read_sky(const std::filesystem::path& path, std::vector<SkySun>& suns) {
    SkyImage image = sky_image(path);
    SkyImage light = image;
    suns = take_suns(light);
    Sky sky;
    sky.image = std::make_shared<const SkyImage>(std::move(image));
    if (!suns.empty()) {
        sky.light = std::make_shared<const SkyImage>(std::move(light));
    }
    return sky;
}

}  // namespace lanthorn
