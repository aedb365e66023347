#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "engine/assets/gltf_check_parts.h"
#include "lanthorn/scene/camera.h"

namespace lanthorn {

using nlohmann::json;

namespace {

constexpr std::size_t kNobody = ~std::size_t{0};

void check_camera(const JsonPlace& camera) {
    camera.string("type", Need::required);
    const std::string type = camera.value()["type"];
    if (type != "perspective" && type != "orthographic") {
        return;  // a type of an extension; the importer stands in another camera
    }
    if (!camera.has(type)) {
        camera.value()[type] = json::object();
    }
    camera.object(type, [&](const JsonPlace& lens) {
        const auto expect = [&](const char* key, double fallback) {
            if (!lens.number(key)) {
                lens.note(key, fmt::format("found nothing; {:g} is used", fallback));
                lens.value()[key] = fallback;
            }
        };
        if (type == "perspective") {
            expect("yfov", static_cast<double>(Camera().y_fov));
            lens.number("zfar");
        } else {
            expect("xmag", 1);
            expect("ymag", 1);
            expect("zfar", 1000);
        }
        expect("znear", 0.05);
        lens.number("aspectRatio");
    });
}

void check_light(const JsonPlace& light) {
    light.string("type", Need::required);
    light.numbers("color", 3);
    light.number("intensity");
    light.number("range");
    light.object("spot", [](const JsonPlace& spot) {
        spot.number("innerConeAngle");
        spot.number("outerConeAngle");
    });
    if (light.value()["type"] == "spot" && !light.has("spot")) {
        light.note("spot", "found nothing; the default angles are used");
        light.value()["spot"] = json::object();  // as other loaders do: all that is in it has a default
    }
}

// An array of `size` arrays, each of which `check` is given with its pointer.
void check_rows(const JsonPlace& place, std::string_view key, std::size_t size,
                const std::function<void(json&, const std::string&)>& check) {
    json& rows = place.value()[key];
    if (!rows.is_array() || rows.empty() || (size > 0 && rows.size() != size)) {
        place.refuse(key, size > 0 ? fmt::format("expected an array of {} arrays", size)
                                   : "expected an array of arrays, at least one");
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        check(rows[i], fmt::format("{}/{}", key, i));
    }
}

void check_image_light(const JsonPlace& light, const json& root) {
    light.string("name");
    light.numbers("rotation", 4);
    light.number("intensity");
    light.integer("specularImageSize", 1, 0x7fffffff);
    const auto refuse = [&](const std::string& place, std::string_view problem) {
        light.file().refuse(light.pointer() + "/" + place, problem);
    };
    if (light.has("irradianceCoefficients")) {
        check_rows(light, "irradianceCoefficients", 9, [&](json& row, const std::string& place) {
            const auto is_number = [](const json& v) {
                return v.is_number() && std::abs(v.get<double>()) <= std::numeric_limits<float>::max();
            };
            if (!row.is_array() || row.size() != 3 || !std::all_of(row.begin(), row.end(), is_number)) {
                refuse(place, "expected three finite 32-bit numbers: red, green, blue");
            }
        });
    }
    const std::size_t images = root.contains("images") ? root["images"].size() : 0;
    if (light.has("specularImages")) {
        check_rows(light, "specularImages", 0, [&](json& row, const std::string& place) {
            const auto is_image = [&](const json& v) {
                return v.is_number_unsigned() && v.get<std::uint64_t>() < images;
            };
            if (!row.is_array() || row.size() != 6 || !std::all_of(row.begin(), row.end(), is_image)) {
                refuse(place, fmt::format("expected six indices below {} (the number of images), one a face "
                                          "of a cube",
                                          images));
            }
        });
    } else if (!light.has("irradianceCoefficients")) {
        light.refuse("found neither 'specularImages' nor 'irradianceCoefficients', expected at least one");
    }
}

void check_scene(const JsonPlace& scene, const json& root) {
    scene.string("name");
    scene.indices("nodes", "nodes");
    scene.object("extensions", [&](const JsonPlace& extensions) {
        extensions.object("EXT_lights_image_based", [&](const JsonPlace& reference) {
            const json::json_pointer lights("/extensions/EXT_lights_image_based/lights");
            const std::size_t count = root.contains(lights) ? root[lights].size() : 0;
            reference.integer("light", 0, 0x7fffffff, Need::required);
            if (reference.get("light") >= count) {
                reference.refuse("light",
                                 fmt::format("found {}, expected an index below {} (the number of lights)",
                                             reference.get("light"), count));
            }
        });
    });
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

void check_instancing(const JsonPlace& extensions, json& root) {
    extensions.object("EXT_mesh_gpu_instancing", [&](const JsonPlace& own) {
        own.object(
            "attributes",
            [&](const JsonPlace& attributes) {
                for (const auto& [key, value] : attributes.value().items()) {
                    check_accessor_use(attributes, key, root);
                }
            },
            Need::required);
    });
}

void check_node(const JsonPlace& node, json& root) {
    node.string("name");
    node.index("mesh", "meshes");
    node.index("camera", "cameras");
    node.index("skin", "skins");
    node.number_list("weights");
    node.indices("children", "nodes");
    const bool matrix = node.numbers("matrix", 16);
    const bool translation = node.numbers("translation", 3);
    const bool rotation = node.numbers("rotation", 4);
    const bool scale = node.numbers("scale", 3);
    if (matrix && (translation || rotation || scale)) {
        node.note("matrix", "found together with translation, rotation or scale; the matrix is used");
        for (const char* key : {"translation", "rotation", "scale"}) {
            node.value().erase(key);
        }
    }
    if (matrix) {
        const json& m = node.value()["matrix"];
        if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
            node.refuse("matrix",
                        "found a projective matrix, expected elements 3, 7, 11 to be 0 and 15 to be 1");
        }
    }
    node.object("extensions", [&](const JsonPlace& extensions) {
        check_node_extensions(extensions, root);
        check_instancing(extensions, root);
        extensions.object("KHR_node_visibility", [](const JsonPlace& own) { own.boolean("visible"); });
    });
}

// Leaves each node with the first parent that names it.
std::vector<std::size_t> mended_parents(GltfFile& file, json& nodes) {
    std::vector<std::size_t> parent(nodes.size(), kNobody);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto children = nodes[i].find("children");
        if (children == nodes[i].end()) {
            continue;
        }
        json kept = json::array();
        for (std::size_t c = 0; c < children->size(); ++c) {
            const std::size_t child = (*children)[c];
            if (parent[child] == kNobody) {
                parent[child] = i;
                kept.push_back(child);
            } else {
                file.note(
                    fmt::format("/nodes/{}/children/{}", i, c),
                    fmt::format(
                        "node {} already is a child of node {}, expected one parent; it stays with that one",
                        child, parent[child]));
            }
        }
        *children = std::move(kept);
    }
    return parent;
}

// Leaves each scene with every node once.
void mend_scenes(GltfFile& file, json& root) {
    const auto scenes = root.find("scenes");
    for (std::size_t s = 0; scenes != root.end() && s < scenes->size(); ++s) {
        const auto listed = (*scenes)[s].find("nodes");
        if (listed == (*scenes)[s].end()) {
            continue;
        }
        std::set<std::size_t> seen;
        json kept = json::array();
        for (std::size_t r = 0; r < listed->size(); ++r) {
            const std::size_t node = (*listed)[r];
            if (seen.insert(node).second) {
                kept.push_back(node);
            } else {
                file.note(fmt::format("/scenes/{}/nodes/{}", s, r),
                          fmt::format("node {} is listed twice; it is shown once", node));
            }
        }
        *listed = std::move(kept);
    }
}

// No node is its own ancestor. Mends nodes with two parents and scenes that list a node twice. A scene that
// lists a node with a parent is mended by the importer.
void check_forest(GltfFile& file, json& root) {
    const auto nodes = root.find("nodes");
    if (nodes == root.end()) {
        return;
    }
    constexpr std::size_t none = kNobody;
    const std::vector<std::size_t> parent = mended_parents(file, *nodes);
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
    mend_scenes(file, root);
}

}  // namespace

void check_nodes(GltfFile& file, const JsonPlace& place, json& root) {
    place.objects("cameras", check_camera);
    place.object("extensions", [&](const JsonPlace& extensions) {
        extensions.object("KHR_lights_punctual",
                          [](const JsonPlace& e) { e.objects("lights", check_light, Need::required); });
        extensions.object("EXT_lights_image_based", [&](const JsonPlace& e) {
            e.objects(
                "lights", [&](const JsonPlace& light) { check_image_light(light, root); }, Need::required);
        });
    });
    place.objects("nodes", [&](const JsonPlace& node) { check_node(node, root); });
    place.objects("scenes", [&](const JsonPlace& scene) { check_scene(scene, root); });
    place.index("scene", "scenes");
    check_forest(file, root);
}

}  // namespace lanthorn
