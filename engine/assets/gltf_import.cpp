#include "lanthorn/assets/gltf_import.h"

#include <algorithm>
#include <limits>
#include <map>
#include <new>
#include <numeric>
#include <stdexcept>

#include "engine/assets/gltf_check.h"
#include "engine/assets/gltf_context.h"
#include "engine/assets/gltf_extensions.h"
#include "engine/assets/scene_budget.h"
#include "engine/assets/solid_blends.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

float GltfContext::clamped(double value, double low, double high, std::string_view place) const {
    if (value >= low && value <= high) {
        return static_cast<float>(value);
    }
    const double mended = std::clamp(value, low, high);
    const std::string range = high < std::numeric_limits<float>::max()
                                  ? fmt::format("{:.7g}..{:.7g}", low, high)
                                  : fmt::format("{:.7g}..", low);
    warn(place, fmt::format("{:.7g} is outside {}; {:.7g} is used", value, range, mended));
    return static_cast<float>(mended);
}

namespace {

// Warnings "PLACE: TEXT" of the same text as one.
std::vector<std::string> told_once(const std::vector<std::string>& warnings) {
    const auto text_of = [](const std::string& warning) { return warning.substr(warning.find(": ")); };
    std::map<std::string, std::size_t> counts;
    for (const std::string& warning : warnings) {
        ++counts[text_of(warning)];
    }
    std::vector<std::string> result;
    for (const std::string& warning : warnings) {
        std::size_t& count = counts[text_of(warning)];
        if (count > 1) {
            result.push_back(
                fmt::format("{} (and at {} more place{})", warning, count - 1, count > 2 ? "s" : ""));
            count = 0;
        } else if (count > 0) {
            result.push_back(warning);
        }
    }
    return result;
}

// By material, whether it can be read or not.
std::vector<bool> with_base_colour_texture(const tinygltf::Model& model) {
    std::vector<bool> result;
    for (const tinygltf::Material& material : model.materials) {
        result.push_back(material.pbrMetallicRoughness.baseColorTexture.index >= 0);
    }
    return result;
}

// Where the nodes, cameras, lights and materials are in the file; what the importer added is nowhere.
void map_to_file(const GltfContext& context, const NodeMap& nodes) {
    FileMap& file = context.scene.file;
    file.nodes.assign(context.scene.nodes.size(), kNone);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i] != kNone) {
            file.nodes[nodes[i]] = static_cast<std::uint32_t>(i);
        }
    }
    const auto in_order = [](std::vector<std::uint32_t>& map, std::size_t given, std::size_t all) {
        map.resize(given);
        std::iota(map.begin(), map.end(), 0u);
        map.resize(all, kNone);
    };
    in_order(file.cameras, context.model.cameras.size(), context.scene.cameras.size());
    in_order(file.lights, context.model.lights.size(), context.scene.lights.size());
    in_order(file.materials, context.model.materials.size(), context.scene.materials.size());
}

// Images and textures that restate_extensions() has added stand behind the file's own.
void forget_beyond(std::vector<std::uint32_t>& map, std::size_t given) {
    std::ranges::replace_if(
        map, [&](std::uint32_t index) { return index >= given; }, kNone);
}

std::size_t count_of(const GltfFile& file, const char* key) {
    const auto found = file.json.find(key);
    return found == file.json.end() ? 0 : found->size();
}

SceneData import_checked(GltfFile& file, const GltfOptions& options) {
    check_gltf(file);
    const std::size_t given_textures = count_of(file, "textures"), given_images = count_of(file, "images");
    restate_extensions(file, options.variant);
    const tinygltf::Model model = build_model(file);
    SceneData scene;
    scene.source = file.name;
    scene.warnings = file.notes;
    std::vector<UvSets> uv_sets;
    const GltfContext context{file, model, scene, file.left, uv_sets};
    import_materials(context);
    const NodeMap nodes = import_nodes(context);
    import_image_light(context);
    import_skins(context, nodes);
    import_animations(context, nodes);
    import_textures(context);
    if (scene.materials.empty()) {
        scene.materials.emplace_back();
    }
    map_to_file(context, nodes);
    forget_beyond(scene.file.textures, given_textures);
    forget_beyond(scene.file.images, given_images);
    make_solid_blends_opaque(scene, with_base_colour_texture(model));
    cut_to_budget(scene);
    scene.warnings = told_once(scene.warnings);
    return scene;
}

}  // namespace

SceneData import_gltf(const std::filesystem::path& path, const GltfOptions& options) {
    GltfFile file = read_gltf_file(path);
    file.allow_outside = options.allow_outside;
    file.left = options.budget;
    try {
        return import_checked(file, options);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw InputError(file.name, "", "does not fit in memory");
    } catch (const std::length_error&) {
        throw InputError(file.name, "", "does not fit in memory");
    } catch (const std::exception& error) {
        file.refuse("", error.what());
    }
}

}  // namespace lanthorn
