// EXT_lights_image_based: the environment that lights a scene, as its sky.

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "engine/assets/gltf_context.h"
#include "engine/assets/image_decode.h"
#include "engine/assets/sky_cube.h"
#include "lanthorn/assets/sky_file.h"
#include "lanthorn/core/colour.h"

namespace lanthorn {

namespace {

using nlohmann::json;

constexpr const char* kExtension = "EXT_lights_image_based";

// Of the scene that is loaded; none: it has no such light.
std::optional<std::size_t> light_of_scene(const GltfContext& context) {
    const json::json_pointer light("/extensions/" + std::string(kExtension) + "/light");
    const auto scene = static_cast<std::size_t>(std::max(context.model.defaultScene, 0));
    if (context.model.scenes.empty() || !context.file.json["scenes"][scene].contains(light)) {
        return std::nullopt;
    }
    return context.file.json["scenes"][scene][light].get<std::size_t>();
}

// RGBD: what the display-encoded colour says, divided by alpha. Images without alpha are what they say.
vec3 radiance_of(const std::uint8_t* rgba) {
    const auto linear = [&](int c) { return linear_from_srgb(static_cast<float>(rgba[c]) / 255.0f); };
    const float divisor = static_cast<float>(std::max<int>(rgba[3], 1)) / 255.0f;
    return vec3(linear(0), linear(1), linear(2)) / divisor;
}

// The largest level of the cube. Nothing, with a warning, if one of its images is not whole.
std::optional<SkyCube> read_cube(const GltfContext& context, const json& light, const std::string& place) {
    const json& level = light["specularImages"][0];
    const std::vector<DecodedImage> faces = load_images(context, level.get<std::vector<std::size_t>>());
    SkyCube cube;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const Image& image = faces[f].image;
        if (!faces[f].problem.empty()) {
            context.warn(
                fmt::format("/images/{}", level[f].get<std::size_t>()),
                fmt::format("the image {}; the environment's images are left out", faces[f].problem));
            return std::nullopt;
        }
        cube.size = f == 0 ? image.width : cube.size;
        if (image.width != cube.size || image.height != cube.size) {
            context.warn(
                fmt::format("{}/specularImages/0/{}", place, f),
                fmt::format("found {} x {} texels, expected {} x {}, all six squares of one size; the "
                            "environment's images are left out",
                            image.width, image.height, cube.size, cube.size));
            return std::nullopt;
        }
        cube.faces[f].reserve(std::size_t{cube.size} * cube.size);
        for (std::size_t i = 0; i < std::size_t{cube.size} * cube.size; ++i) {
            cube.faces[f].push_back(radiance_of(&image.rgba[4 * i]));
        }
    }
    if (light.value("specularImageSize", std::uint64_t{cube.size}) != cube.size) {
        context.warn(place + "/specularImageSize",
                     fmt::format("found {}, but the images have {} texels a side; those are used",
                                 light["specularImageSize"].get<std::uint64_t>(), cube.size));
    }
    return cube;
}

IrradianceHarmonics read_harmonics(const json& light) {
    IrradianceHarmonics harmonics;
    for (std::size_t i = 0; i < harmonics.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            harmonics[i][c] = light["irradianceCoefficients"][i][static_cast<std::size_t>(c)].get<float>();
        }
    }
    return harmonics;
}

}  // namespace

void import_image_light(const GltfContext& context) {
    const std::optional<std::size_t> index = light_of_scene(context);
    if (!index) {
        return;
    }
    const json& light = context.file.json["extensions"][kExtension]["lights"][*index];
    const std::string place = fmt::format("/extensions/{}/lights/{}", kExtension, *index);
    std::optional<SkyImage> image;
    if (light.contains("specularImages")) {
        if (const std::optional<SkyCube> cube = read_cube(context, light, place)) {
            image = sky_of_cube(*cube);
        }
    }
    if (!image && light.contains("irradianceCoefficients")) {
        image = sky_of_harmonics(read_harmonics(light));
    }
    if (!image) {
        return;
    }
    image->name = light.value("name", std::string("environment"));
    NodeData node;
    node.name = image->name;
    if (light.contains("rotation")) {
        node.local.rotation = read_rotation(context, light["rotation"].get<std::vector<double>>(), place);
    }
    const double intensity = light.value("intensity", 1.0);
    const bool finite = std::ranges::all_of(image->radiance, [&](const vec3& c) {
        const dvec3 most(std::numeric_limits<float>::max());
        return glm::all(glm::lessThanEqual(glm::abs(dvec3(c) * intensity), most));
    });
    if (!finite) {
        context.warn(place, "found radiance beyond 32-bit numbers; the environment is left out");
        return;
    }
    std::vector<SkySun> suns;
    Sky sky = sky_without_suns(std::move(*image), suns);
    sky.intensity = context.clamped(intensity, 0, std::numeric_limits<float>::max(), place + "/intensity");
    add_sky_nodes(context.scene, std::move(node), std::move(sky), suns);
}

}  // namespace lanthorn
