#include "engine/assets/gltf_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "engine/assets/gltf_format.h"
#include "engine/assets/json_checker.h"

namespace lanthorn {

using nlohmann::json;

namespace {

constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 40;  // of one buffer; far above what fits in memory
constexpr std::uint64_t kMaxCount = 0xffffffff;              // elements of an accessor: 32-bit indices

// The extensions that a file may require of us.
constexpr std::array<std::string_view, 8> kKnownExtensions = {
    "KHR_lights_punctual",        "KHR_materials_emissive_strength",
    "KHR_materials_ior",          "KHR_materials_specular",
    "KHR_materials_transmission", "KHR_materials_unlit",
    "KHR_mesh_quantization",      "KHR_texture_transform"};

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

void check_buffer(const JsonPlace& buffer) {
    buffer.integer("byteLength", 1, kMaxBytes, Need::required);
    buffer.string("uri");
}

void check_buffer_view(const JsonPlace& view, json& root) {
    view.index("buffer", "buffers", Need::required);
    view.integer("byteOffset", 0, kMaxBytes);
    view.integer("byteLength", 1, kMaxBytes, Need::required);
    view.integer("byteStride", 4, 252);
    if (view.get("byteStride") % 4 != 0) {
        view.refuse("byteStride", fmt::format("found {}, expected a multiple of 4", view.get("byteStride")));
    }
    const std::uint64_t end = view.get("byteOffset") + view.get("byteLength");
    const std::uint64_t size = root["buffers"][view.get("buffer")]["byteLength"];
    if (end > size) {
        view.refuse("byteLength", fmt::format("the view ends at byte {}, but buffer {} has {}", end,
                                              view.get("buffer"), size));
    }
}

// That `count` elements of `size` bytes from `offset`, `stride` apart, lie in the buffer view named by
// `place`.
void check_fits(const JsonPlace& place, json& root, std::uint64_t count, std::uint64_t size) {
    const json& view = root["bufferViews"][place.get("bufferView")];
    const std::uint64_t stride = view.value("byteStride", std::uint64_t{0});
    if (stride != 0 && stride < size) {
        place.refuse(
            "bufferView",
            fmt::format("the view's byteStride {} is smaller than an element of {} bytes", stride, size));
    }
    const std::uint64_t end =
        place.get("byteOffset") + (count - 1) * (stride != 0 ? stride : size) + size;  // below 2^42
    const std::uint64_t length = view["byteLength"];
    if (end > length) {
        place.refuse("bufferView",
                     fmt::format("{} elements of {} bytes end at byte {}, but buffer view {} has {}", count,
                                 size, end, place.get("bufferView"), length));
    }
}

void expect_component(const JsonPlace& place, std::initializer_list<std::uint64_t> allowed) {
    place.integer("componentType", 0, 0xffff, Need::required);
    const std::uint64_t type = place.get("componentType");
    if (std::find(allowed.begin(), allowed.end(), type) == allowed.end()) {
        place.refuse("componentType",
                     fmt::format("found {}, expected one of {}", type, fmt::join(allowed, ", ")));
    }
}

void check_sparse(const JsonPlace& sparse, json& root, std::uint64_t accessor_count,
                  std::uint64_t element_size) {
    sparse.integer("count", 1, std::min<std::uint64_t>(accessor_count, 0x7fffffff), Need::required);
    const std::uint64_t count = sparse.get("count");
    const auto check_part = [&](const JsonPlace& part, std::uint64_t size) {
        part.index("bufferView", "bufferViews", Need::required);
        part.integer("byteOffset", 0, 0x7fffffff);  // tinygltf holds it in an int
        if (root["bufferViews"][part.get("bufferView")].contains("byteStride")) {
            part.refuse("bufferView", "the view has a byteStride, expected none for sparse data");
        }
        check_fits(part, root, count, size);
    };
    sparse.object(
        "indices",
        [&](const JsonPlace& part) {
            expect_component(part, {kUnsignedByte, kUnsignedShort, kUnsignedInt});
            check_part(part, component_size(part.get("componentType")));
        },
        Need::required);
    sparse.object(
        "values", [&](const JsonPlace& part) { check_part(part, element_size); }, Need::required);
}

void check_accessor(const JsonPlace& accessor, json& root) {
    expect_component(accessor, {kByte, kUnsignedByte, kShort, kUnsignedShort, kUnsignedInt, kFloat});
    accessor.string("type", Need::required);
    accessor.integer("count", 1, kMaxCount, Need::required);
    accessor.boolean("normalized");
    accessor.index("bufferView", "bufferViews");
    accessor.integer("byteOffset", 0, kMaxBytes);
    const std::uint64_t count = accessor.get("count");
    const std::uint64_t size =
        element_size(accessor.get("componentType"), accessor.value()["type"].get_ref<const std::string&>());
    if (size == 0) {
        return;  // a type of an extension; refused where it is used
    }
    if (accessor.has("bufferView")) {
        check_fits(accessor, root, count, size);
    } else if (count > kMaxZeroElements) {
        accessor.refuse("count", fmt::format("found {} elements without a buffer view, expected at most {}",
                                             count, kMaxZeroElements));
    }
    accessor.object("sparse", [&](const JsonPlace& sparse) { check_sparse(sparse, root, count, size); });
}

// A reference to an accessor of a type that we know.
void check_accessor_use(const JsonPlace& place, std::string_view key, json& root) {
    if (place.index(key, "accessors")) {
        const std::string type = root["accessors"][place.get(key)]["type"];
        if (component_count(type) == 0) {
            place.refuse(key, fmt::format("accessor {} has the unknown type '{}'", place.get(key), type));
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
    check_accessor_use(primitive, "indices", root);
    primitive.index("material", "materials");
    primitive.integer("mode", 0, 6);
}

void check_mesh(const JsonPlace& mesh, json& root) {
    mesh.string("name");
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

void check_camera(const JsonPlace& camera) {
    camera.string("type", Need::required);
    const std::string type = camera.value()["type"];
    if (type != "perspective" && type != "orthographic") {
        return;  // a type of an extension; the importer stands in another camera
    }
    camera.object(
        type,
        [&](const JsonPlace& lens) {
            const bool perspective = type == "perspective";
            lens.number("yfov", perspective ? Need::required : Need::optional);
            lens.number("aspectRatio");
            lens.number("xmag", perspective ? Need::optional : Need::required);
            lens.number("ymag", perspective ? Need::optional : Need::required);
            lens.number("znear", Need::required);
            lens.number("zfar", perspective ? Need::optional : Need::required);
        },
        Need::required);
}

void check_light(const JsonPlace& light) {
    light.string("type", Need::required);
    light.numbers("color", 3);
    light.number("intensity");
    light.number("range");
    light.object(
        "spot",
        [](const JsonPlace& spot) {
            spot.number("innerConeAngle");
            spot.number("outerConeAngle");
        },
        light.value()["type"] == "spot" ? Need::required : Need::optional);
}

void check_node_extensions(const JsonPlace& extensions, json& root) {
    extensions.object("KHR_lights_punctual", [&](const JsonPlace& reference) {
        const json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
        const std::size_t count = root.contains(lights) && root[lights].is_array() ? root[lights].size() : 0;
        reference.integer("light", 0, 0x7fffffff, Need::required);
        if (reference.get("light") >= count) {
            reference.refuse("light",
                             fmt::format("found {}, expected an index below {} (the number of lights)",
                                         reference.get("light"), count));
        }
    });
}

void check_node(const JsonPlace& node, json& root) {
    node.string("name");
    node.index("mesh", "meshes");
    node.index("camera", "cameras");
    node.indices("children", "nodes");
    const bool matrix = node.numbers("matrix", 16);
    const bool trs = node.numbers("translation", 3) | node.numbers("rotation", 4) | node.numbers("scale", 3);
    if (matrix && trs) {
        node.refuse("matrix",
                    "found together with translation, rotation or scale, expected one or the other");
    }
    if (matrix) {
        const json& m = node.value()["matrix"];
        if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
            node.refuse("matrix",
                        "found a projective matrix, expected elements 3, 7, 11 to be 0 and 15 to be 1");
        }
    }
    node.object("extensions", [&](const JsonPlace& extensions) { check_node_extensions(extensions, root); });
}

// Every node has at most one parent, and no node is its own ancestor.
void check_forest(const GltfFile& file, const json& root) {
    const auto nodes = root.find("nodes");
    if (nodes == root.end()) {
        return;
    }
    constexpr std::size_t none = ~std::size_t{0};
    std::vector<std::size_t> parent(nodes->size(), none);
    for (std::size_t i = 0; i < nodes->size(); ++i) {
        const json children = (*nodes)[i].value("children", json::array());
        for (std::size_t c = 0; c < children.size(); ++c) {
            const std::size_t child = children[c];
            if (parent[child] != none) {
                file.refuse(fmt::format("/nodes/{}/children/{}", i, c),
                            fmt::format("node {} already is a child of node {}, expected one parent", child,
                                        parent[child]));
            }
            parent[child] = i;
        }
    }
    std::vector<std::size_t> seen_from(nodes->size(), none);  // the walk that first came here
    for (std::size_t i = 0; i < nodes->size(); ++i) {
        std::size_t at = i;
        while (at != none && seen_from[at] == none) {
            seen_from[at] = i;
            at = parent[at];
        }
        if (at != none && seen_from[at] == i) {
            file.refuse(fmt::format("/nodes/{}/children", at),
                        fmt::format("node {} is its own ancestor, expected a tree", at));
        }
    }
    const json scenes = root.value("scenes", json::array());
    for (std::size_t s = 0; s < scenes.size(); ++s) {
        const json roots = scenes[s].value("nodes", json::array());
        std::set<std::size_t> seen;
        for (std::size_t r = 0; r < roots.size(); ++r) {
            const std::size_t node = roots[r];
            const std::string place = fmt::format("/scenes/{}/nodes/{}", s, r);
            if (parent[node] != none) {
                file.refuse(
                    place, fmt::format("node {} is a child of node {}, expected a root", node, parent[node]));
            }
            if (!seen.insert(node).second) {
                file.refuse(place, fmt::format("node {} is listed twice", node));
            }
        }
    }
}

}  // namespace

void check_gltf(GltfFile& file) {
    json& root = file.json;
    const JsonPlace place(file, root, "");
    check_asset(place);
    check_required_extensions(file, place);
    place.objects("buffers", check_buffer);
    place.objects("bufferViews", [&](const JsonPlace& view) { check_buffer_view(view, root); });
    place.objects("accessors", [&](const JsonPlace& accessor) { check_accessor(accessor, root); });
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
    place.objects("cameras", check_camera);
    place.object("extensions", [](const JsonPlace& extensions) {
        extensions.object("KHR_lights_punctual",
                          [](const JsonPlace& e) { e.objects("lights", check_light, Need::required); });
    });
    place.objects("nodes", [&](const JsonPlace& node) { check_node(node, root); });
    place.objects("scenes", [](const JsonPlace& scene) {
        scene.string("name");
        scene.indices("nodes", "nodes");
    });
    place.index("scene", "scenes");
    check_forest(file, root);
}

}  // namespace lanthorn
