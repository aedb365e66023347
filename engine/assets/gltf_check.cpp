#include "engine/assets/gltf_check.h"

#include <fmt/format.h>

#include "engine/assets/gltf_check_parts.h"
#include "engine/assets/gltf_extensions.h"
#include "engine/assets/gltf_format.h"

namespace lanthorn {

using nlohmann::json;

namespace {

void check_asset(const JsonPlace& root) {
    root.object(
        "asset",
        [](const JsonPlace& asset) {
            if (asset.has("version") && asset.value()["version"] == 2) {  // a number
                asset.note("version", "found the number 2, expected a string; '2.0' is read");
                asset.value()["version"] = "2.0";
            }
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

void check_draco(const JsonPlace& draco) {
    draco.index("bufferView", "bufferViews", Need::required);
    draco.object(
        "attributes",
        [](const JsonPlace& attributes) {
            for (const auto& [key, value] : attributes.value().items()) {
                attributes.integer(key, 0, 0x7fffffff);
            }
        },
        Need::required);
}

const json::json_pointer kVariants("/extensions/KHR_materials_variants/variants");

void check_mappings(const JsonPlace& own, const json& root) {
    const std::size_t variants = root.contains(kVariants) ? root[kVariants].size() : 0;
    own.objects(
        "mappings",
        [&](const JsonPlace& mapping) {
            mapping.index("material", "materials", Need::required);
            if (!mapping.has("variants") || !mapping.value()["variants"].is_array()) {
                mapping.refuse("variants", "expected an array of indices");
            }
            for (json& variant : mapping.value()["variants"]) {
                if (!variant.is_number_unsigned() || variant.get<std::uint64_t>() >= variants) {
                    mapping.refuse(
                        "variants",
                        fmt::format("expected indices below {} (the number of variants)", variants));
                }
            }
        },
        Need::required);
}

void check_variants(const JsonPlace& root) {
    root.object("extensions", [](const JsonPlace& extensions) {
        extensions.object("KHR_materials_variants", [](const JsonPlace& own) {
            own.objects(
                "variants", [](const JsonPlace& variant) { variant.string("name", Need::required); },
                Need::required);
        });
    });
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
    primitive.object("extensions", [&](const JsonPlace& extensions) {
        extensions.object("KHR_draco_mesh_compression", check_draco);
        extensions.object("KHR_materials_variants", [&](const JsonPlace& own) { check_mappings(own, root); });
    });
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
    extensions.object("KHR_materials_pbrSpecularGlossiness", [](const JsonPlace& e) {
        e.numbers("diffuseFactor", 4);
        e.numbers("specularFactor", 3);
        e.number("glossinessFactor");
        e.object("diffuseTexture", check_texture_info);
        e.object("specularGlossinessTexture", check_texture_info);
    });
    extensions.object("KHR_materials_clearcoat", [](const JsonPlace& e) {
        e.number("clearcoatFactor");
        e.number("clearcoatRoughnessFactor");
        for (const char* key : {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"}) {
            e.object(key, check_texture_info);
        }
    });
    extensions.object("KHR_materials_sheen", [](const JsonPlace& e) {
        e.numbers("sheenColorFactor", 3);
        e.number("sheenRoughnessFactor");
        e.object("sheenColorTexture", check_texture_info);
        e.object("sheenRoughnessTexture", check_texture_info);
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
    check_extensions(place);
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
        texture.object("extensions", [](const JsonPlace& extensions) {
            extensions.object("EXT_texture_webp",
                              [](const JsonPlace& webp) { webp.index("source", "images"); });
        });
    });
    place.objects("materials", check_material);
    check_variants(place);
    place.objects("meshes", [&](const JsonPlace& mesh) { check_mesh(mesh, root); });
    check_nodes(file, place, root);
    check_skins(place, root);
    check_animations(place, root);
}

}  // namespace lanthorn
