#include "lanthorn/assets/gltf_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lanthorn/assets/gltf_check_parts.h"
#include "lanthorn/assets/gltf_format.h"

namespace lanthorn {

using nlohmann::json;

namespace {

// The extensions that a file may require of us.
constexpr std::array<std::string_view, 10> kKnownExtensions = {
    "EXT_lights_image_based", "KHR_lights_punctual",    "KHR_materials_emissive_strength",
    "KHR_materials_ior",      "KHR_materials_specular", "KHR_materials_transmission",
    "KHR_materials_unlit",    "KHR_materials_volume",   "KHR_mesh_quantization",
    "KHR_texture_transform"};

void check_asset(const JsonPlace& root) {
    root.object(
        "asset",
        [](const JsonPlace& asset) {
            asset.string("version", Need::required);
            const std::string version = asset.value()["version"];
            if (!version.starts_with("2.") || version.size() == 2) {
                asset.refuse("version", fmt::format("found glTF version '{}', expected 2.x", version));
            }
            if (asset.string("minVersion")) {
                const std::string minimum = asset.value()["minVersion"];
                if (minimum != "2.0") {
                    asset.refuse("minVersion",
                                 fmt::format("found '{}', expected 2.0, which is what we read", minimum));
                }
            }
        },
        Need::required);
}

void check_required_extensions(const GltfFile& file, const JsonPlace& root) {
    const auto found = root.value().find("extensionsRequired");
    if (found == root.value().end()) {
        return;
    }
    if (!found->is_array()) {
        root.refuse("extensionsRequired", "expected an array of strings");
    }
    for (std::size_t i = 0; i < found->size(); ++i) {
        const json& name = (*found)[i];
        if (!name.is_string()) {
            root.refuse("extensionsRequired", "expected an array of strings");
        }
        const std::string& text = name.get_ref<const std::string&>();
        if (std::find(kKnownExtensions.begin(), kKnownExtensions.end(), text) == kKnownExtensions.end()) {
            file.refuse(fmt::format("/extensionsRequired/{}", i),
                        fmt::format("the file requires the extension '{}', which is not "
                                    "supported; supported are {}",
                                    text, fmt::join(kKnownExtensions, ", ")));
        }
    }
}

void check_primitive(const JsonPlace& primitive, json& root) {
    primitive.object(
        "attributes",
        [&](const JsonPlace& attributes) {
            for (const auto& [key, value] : attributes.value().items()) {
                check_accessor_use(attributes, key, root);
            }
        },
        Need::required);
    primitive.objects("targets", [&](const JsonPlace& target) {
        for (const auto& [key, value] : target.value().items()) {
            check_accessor_use(target, key, root);
        }
    });
    check_accessor_use(primitive, "indices", root);
    primitive.index("material", "materials");
    primitive.integer("mode", 0, 6);
}

void check_mesh(const JsonPlace& mesh, json& root) {
    mesh.string("name");
    mesh.number_list("weights");
    mesh.objects(
        "primitives", [&](const JsonPlace& primitive) { check_primitive(primitive, root); }, Need::required);
}

void check_texture_info(const JsonPlace& info) {
    info.index("index", "textures", Need::required);
    info.integer("texCoord", 0, 0xffff);
    info.number("scale");
    info.number("strength");
    info.object("extensions", [](const JsonPlace& extensions) {
        extensions.object("KHR_texture_transform", [](const JsonPlace& transform) {
            transform.numbers("offset", 2);
            transform.number("rotation");
            transform.numbers("scale", 2);
            transform.integer("texCoord", 0, 0xffff);
        });
    });
}

void check_material_extensions(const JsonPlace& extensions) {
    extensions.object("KHR_materials_emissive_strength",
                      [](const JsonPlace& e) { e.number("emissiveStrength"); });
    extensions.object("KHR_materials_ior", [](const JsonPlace& e) { e.number("ior"); });
    extensions.object("KHR_materials_unlit", [](const JsonPlace&) {});
    extensions.object("KHR_materials_specular", [](const JsonPlace& e) {
        e.number("specularFactor");
        e.numbers("specularColorFactor", 3);
        e.object("specularTexture", check_texture_info);
        e.object("specularColorTexture", check_texture_info);
    });
    extensions.object("KHR_materials_transmission", [](const JsonPlace& e) {
        e.number("transmissionFactor");
        e.object("transmissionTexture", check_texture_info);
    });
    extensions.object("KHR_materials_volume", [](const JsonPlace& e) {
        e.number("thicknessFactor");
        e.object("thicknessTexture", check_texture_info);
        e.number("attenuationDistance");
        e.numbers("attenuationColor", 3);
    });
}

void check_material(const JsonPlace& material) {
    material.string("name");
    material.object("pbrMetallicRoughness", [](const JsonPlace& pbr) {
        pbr.numbers("baseColorFactor", 4);
        pbr.number("metallicFactor");
        pbr.number("roughnessFactor");
        pbr.object("baseColorTexture", check_texture_info);
        pbr.object("metallicRoughnessTexture", check_texture_info);
    });
    material.object("normalTexture", check_texture_info);
    material.object("occlusionTexture", check_texture_info);
    material.object("emissiveTexture", check_texture_info);
    material.numbers("emissiveFactor", 3);
    material.string("alphaMode");
    material.number("alphaCutoff");
    material.boolean("doubleSided");
    material.object("extensions", check_material_extensions);
}

void check_image(const JsonPlace& image) {
    image.string("name");
    image.string("uri");
    image.string("mimeType");
    image.index("bufferView", "bufferViews");
    if (image.has("uri") == image.has("bufferView")) {
        image.refuse("expected exactly one of 'uri' and 'bufferView'");
    }
}

}  // namespace

void check_gltf(GltfFile& file) {
    json& root = file.json;
    const JsonPlace place(file, root, "");
    check_asset(place);
    check_required_extensions(file, place);
    check_buffers(place, root);
    place.objects("images", check_image);
    place.objects("samplers", [](const JsonPlace& sampler) {
        for (const char* key : {"magFilter", "minFilter", "wrapS", "wrapT"}) {
            sampler.integer(key, 0, 0xffff);
        }
    });
    place.objects("textures", [](const JsonPlace& texture) {
        texture.index("sampler", "samplers");
        texture.index("source", "images");
    });
    place.objects("materials", check_material);
    place.objects("meshes", [&](const JsonPlace& mesh) { check_mesh(mesh, root); });
    check_nodes(file, place, root);
    check_skins(place, root);
    check_animations(place, root);
}

}  // namespace lanthorn
