#include "lanthorn/assets/gltf_import.h"

#include <algorithm>
#include <limits>
#include <new>

#include "lanthorn/assets/gltf_check.h"
#include "lanthorn/assets/gltf_context.h"
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

SceneData import_checked(GltfFile& file) {
    check_gltf(file);
    const tinygltf::Model model = build_model(file);
    SceneData scene;
    scene.source = file.name;
    const GltfContext context{file, model, scene};
    import_materials(context);
    const NodeMap nodes = import_nodes(context);
    import_image_light(context);
    import_skins(context, nodes);
    import_animations(context, nodes);
    import_textures(context);
    if (scene.materials.empty()) {
        scene.materials.emplace_back();
    }
    return scene;
}

}  // namespace

SceneData import_gltf(const std::filesystem::path& path) {
    GltfFile file = read_gltf_file(path);
    try {
        return import_checked(file);
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
