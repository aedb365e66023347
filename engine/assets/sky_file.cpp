#include "lanthorn/assets/sky_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <glm/gtx/quaternion.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

constexpr int kLargest = 8192;  // 0.4 GB, and as much again without its suns

SkyImage sky_image(const std::filesystem::path& path, std::size_t& mended) {
    ImageF image = read_image(path);
    const std::string name = path.string();
    if (image.width > kLargest || image.height > kLargest / 2 || image.width < image.height ||
        image.width > 4 * image.height) {
        throw InputError(
            name, "",
            fmt::format("found {} x {} pixels, expected an equirectangular image: about twice as "
                        "wide as high, at most {} x {}",
                        image.width, image.height, kLargest, kLargest / 2));
    }
    mended = repair_pixels(image, false, true);
    SkyImage sky;
    sky.name = path.filename().string();
    sky.width = static_cast<std::uint32_t>(image.width);
    sky.height = static_cast<std::uint32_t>(image.height);
    sky.radiance.reserve(std::size_t{sky.width} * sky.height);
    const bool grey = image.channels < 3;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            vec3 c(image.at(x, y, 0), image.at(x, y, grey ? 0 : 1), image.at(x, y, grey ? 0 : 2));
            for (int i = 0; i < 3 && !image.linear; ++i) {
                c[i] = linear_from_srgb(c[i]);
            }
            sky.radiance.push_back(c);
        }
    }
    return sky;
}

}  // namespace

Sky sky_without_suns(SkyImage image, std::vector<SkySun>& suns) {
    SkyImage light = image;
    suns = take_suns(light);
    Sky sky;
    sky.image = std::make_shared<const SkyImage>(std::move(image));
    if (!suns.empty()) {
        sky.light = std::make_shared<const SkyImage>(std::move(light));
    }
    return sky;
}

Sky read_sky(const std::filesystem::path& path, std::vector<SkySun>& suns, std::string* note) {
    std::size_t mended = 0;
    SkyImage image = sky_image(path, mended);
    if (mended > 0 && note != nullptr) {
        *note = fmt::format("{}: {} pixel{} negative, infinite or no number; replaced by what lies around",
                            path.string(), mended, mended == 1 ? " is" : "s are");
    }
    return sky_without_suns(std::move(image), suns);
}

void add_sky_nodes(SceneData& scene, NodeData node, Sky sky, const std::vector<SkySun>& suns) {
    const auto parent = static_cast<std::uint32_t>(scene.nodes.size());
    const std::string name = node.name;
    const float intensity = sky.intensity;
    node.sky = static_cast<std::uint32_t>(scene.skies.size());
    scene.skies.push_back(std::move(sky));
    scene.nodes.push_back(std::move(node));
    for (const SkySun& sun : suns) {
        const float largest = std::max({sun.illuminance.x, sun.illuminance.y, sun.illuminance.z});
        Light light;
        light.type = LightType::directional;
        light.intensity = largest * intensity;
        light.colour = sun.illuminance / largest;
        NodeData below;
        below.name = "sun of " + name;
        below.parent = parent;
        below.light = static_cast<std::uint32_t>(scene.lights.size());
        below.local.rotation = glm::rotation(vec3(0, 0, -1), -sun.towards);
        scene.lights.push_back(light);
        scene.nodes.push_back(std::move(below));
    }
}

}  // namespace lanthorn
