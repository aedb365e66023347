// Changing a document's nodes.
#include <fmt/format.h>

#include <cmath>

#include "engine/assets/gltf_document_state.h"
#include "engine/assets/matrix_parts.h"
#include "engine/core/finite.h"

namespace lanthorn {

namespace {

using Json = nlohmann::json;

std::string node_place(std::size_t node) {
    return fmt::format("/nodes/{}", node);
}

// A node's transform as the importer reads it.
void read_transform(const JsonText& node, Transform& local, mat3& shear) {
    local = {};
    shear = mat3(1);
    if (const Json matrix = parsed(node, "matrix"); !matrix.is_null()) {
        dmat4 elements;
        for (int i = 0; i < 16; ++i) {
            elements[i / 4][i % 4] = matrix[static_cast<std::size_t>(i)];
        }
        decompose(elements, local, shear);
        return;
    }
    if (const Json t = parsed(node, "translation"); !t.is_null()) {
        local.translation = {t[0].get<double>(), t[1].get<double>(), t[2].get<double>()};
    }
    if (const Json s = parsed(node, "scale"); !s.is_null()) {
        local.scale = {s[0].get<double>(), s[1].get<double>(), s[2].get<double>()};
    }
    if (const Json r = parsed(node, "rotation"); !r.is_null()) {
        const glm::dquat q(r[3].get<double>(), r[0].get<double>(), r[1].get<double>(), r[2].get<double>());
        const double length = glm::length(q);
        local.rotation = length > 1e-12 ? quat(q / length) : quat(1, 0, 0, 0);
    }
}

// As floats, which the file holds: a double may be finite and no float.
bool fits_floats(const dvec3& v) {
    return is_finite(vec3(v));
}

void erase_index(JsonText& owner, std::string_view key, std::size_t index) {
    JsonText* list = owner.find(key);
    for (std::size_t i = list == nullptr ? 0 : list->size(); i-- > 0;) {
        if (parsed(list->at(i)).get<double>() == static_cast<double>(index)) {
            list->erase(i);
        }
    }
    if (list != nullptr && list->size() == 0) {
        owner.erase(key);  // glTF knows no empty lists
    }
}

void append_index(JsonText& owner, std::string_view key, std::size_t index) {
    JsonText* list = owner.find(key);
    (list == nullptr ? owner.set(key, JsonText("[]")) : *list).append(JsonText(std::to_string(index)));
}

}  // namespace

void GltfDocument::set_node_name(std::size_t node, std::string_view name) {
    JsonText& target = state_->element("nodes", node);
    const std::string quoted = json_quoted(name);
    if (node_name(node) != name) {
        target.set("name", JsonText(quoted));
    }
}

void GltfDocument::set_transform(std::size_t node, const Transform& local, const mat3& shear) {
    JsonText& target = state_->element("nodes", node);
    const quat& q = local.rotation;
    const vec4 rotation(q.x, q.y, q.z, q.w);
    const auto expect = [&](bool holds, const char* key, const char* expected) {
        if (!holds) {
            state_->refuse(fmt::format("{}/{}", node_place(node), key), expected);
        }
    };
    constexpr const char* kFinite = "found a number that is not finite, expected finite 32-bit numbers";
    expect(fits_floats(local.translation), "translation", kFinite);
    expect(fits_floats(local.scale), "scale", kFinite);
    expect(fits_floats(shear[0]) && fits_floats(shear[1]) && fits_floats(shear[2]), "matrix", kFinite);
    expect(std::abs(glm::length(rotation) - 1) <= 1e-2f, "rotation",
           "found a quaternion that is not of unit length, expected length 1");

    Transform known;
    mat3 known_shear;
    read_transform(target, known, known_shear);
    if (known == local && known_shear == shear) {
        return;
    }
    if (shear != mat3(1)) {
        const dmat4 matrix = local.matrix() * dmat4(glm::dmat3(shear));
        Json elements = Json::array();
        for (int i = 0; i < 16; ++i) {
            elements.push_back(plain_number(matrix[i / 4][i % 4]));
        }
        for (const char* key : {"translation", "rotation", "scale"}) {
            target.erase(key);
        }
        target.set("matrix", JsonText(elements.dump()));
        return;
    }
    if (target.erase("matrix")) {
        known = {};
    }
    patch(target, "translation", plain_numbers(local.translation), Json{0, 0, 0}, true);
    if (known.rotation != local.rotation) {
        target.set("rotation", JsonText(plain_numbers(rotation).dump()));
    }
    patch(target, "scale", plain_numbers(local.scale), Json{1, 1, 1});
}

void GltfDocument::set_extras(std::size_t node, std::string_view json) {
    JsonText& target = state_->element("nodes", node);
    if (json.empty()) {
        target.erase("extras");
        return;
    }
    const Json value = state_->given_json(node_place(node) + "/extras", json);
    if (target.find("extras") == nullptr || parsed(target, "extras") != value) {
        target.set("extras", JsonText(value.dump()));
    }
}

void GltfDocument::set_extra(std::size_t node, std::string_view key, std::string_view json) {
    JsonText& target = state_->element("nodes", node);
    const std::string place = node_place(node) + "/extras";
    const Json value = state_->given_json(fmt::format("{}/{}", place, key), json);
    JsonText* extras = target.find("extras");
    if (extras != nullptr && !extras->is_object()) {
        state_->refuse(place, "found no object, expected one to set a member of");
    }
    if (extras != nullptr && extras->find(key) != nullptr && parsed(*extras, key) == value) {
        return;
    }
    (extras == nullptr ? target.set("extras", JsonText("{}")) : *extras).set(key, JsonText(value.dump()));
}

void GltfDocument::remove_extra(std::size_t node, std::string_view key) {
    JsonText& target = state_->element("nodes", node);
    JsonText* extras = target.find("extras");
    if (extras != nullptr && extras->erase(key) && extras->size() == 0) {
        target.erase("extras");
    }
}

void GltfDocument::set_node_mesh(std::size_t node, std::uint32_t mesh) {
    state_->set_reference(node, "mesh", mesh, "meshes", mesh_count());
}

void GltfDocument::set_node_camera(std::size_t node, std::uint32_t camera) {
    state_->set_reference(node, "camera", camera, "cameras", camera_count());
}

void GltfDocument::set_node_skin(std::size_t node, std::uint32_t skin) {
    state_->set_reference(node, "skin", skin, "skins", state_->count("skins"));
}

void GltfDocument::State::set_reference(std::size_t node, std::string_view key, std::uint32_t index,
                                        std::string_view collection, std::size_t size) {
    JsonText& target = element("nodes", node);
    if (index == kNone) {
        target.erase(key);
        return;
    }
    if (index >= size) {
        refuse(
            fmt::format("{}/{}", node_place(node), key),
            fmt::format("found {}, expected an index below {} (the number of {})", index, size, collection));
    }
    patch(target, key, index, Json());
}

void GltfDocument::set_node_light(std::size_t node, std::uint32_t light) {
    JsonText& target = state_->element("nodes", node);
    if (light == kNone) {
        if (JsonText* extensions = target.find("extensions");
            extensions != nullptr && extensions->erase("KHR_lights_punctual") && extensions->size() == 0) {
            target.erase("extensions");
        }
        return;
    }
    if (light >= light_count()) {
        state_->refuse(
            node_place(node) + "/extensions/KHR_lights_punctual/light",
            fmt::format("found {}, expected an index below {} (the number of lights)", light, light_count()));
    }
    patch(object_at(object_at(target, "extensions"), "KHR_lights_punctual"), "light", light, Json());
}

void GltfDocument::set_node_visible(std::size_t node, bool visible) {
    JsonText& target = state_->element("nodes", node);
    JsonText* extensions = target.find("extensions");
    const bool is_stated = extensions != nullptr && extensions->find("KHR_node_visibility") != nullptr;
    if (visible && !is_stated) {
        return;
    }
    state_->use_extension("KHR_node_visibility");
    patch(object_at(object_at(target, "extensions"), "KHR_node_visibility"), "visible", visible, true);
}

// The default scene, or nullptr where there are no scenes and every node without a parent is shown.
JsonText* GltfDocument::State::scene() {
    return count("scenes") == 0 ? nullptr : &element("scenes", index_at(root, "scene", 0));
}

void GltfDocument::State::detach(std::size_t node) {
    for (const auto& [collection, key] : {std::pair("nodes", "children"), std::pair("scenes", "nodes")}) {
        for (std::size_t i = 0; i < count(collection); ++i) {
            erase_index(element(collection, i), key, node);
        }
    }
}

std::size_t GltfDocument::State::parent_of(std::size_t node) const {
    for (std::size_t i = 0; i < count("nodes"); ++i) {
        for (const Json& child : parsed(element("nodes", i), "children")) {
            if (child.get<double>() == static_cast<double>(node)) {
                return i;
            }
        }
    }
    return kNone;
}

std::size_t GltfDocument::add_node(std::string_view name, std::uint32_t parent) {
    if (parent != kNone) {
        state_->element("nodes", parent);
    }
    const std::size_t node = state_->append("nodes", JsonText("{\"name\":" + json_quoted(name) + "}"));
    if (parent != kNone) {
        append_index(state_->element("nodes", parent), "children", node);
    } else if (JsonText* scene = state_->scene()) {
        append_index(*scene, "nodes", node);
    }
    return node;
}

void GltfDocument::set_parent(std::size_t node, std::uint32_t parent) {
    state_->element("nodes", node);
    if (parent != kNone) {
        state_->element("nodes", parent);
        for (std::size_t above = parent; above != kNone; above = state_->parent_of(above)) {
            if (above == node) {
                state_->refuse(node_place(parent) + "/children",
                               fmt::format("node {} stands above node {}, expected a tree", node, parent));
            }
        }
    }
    state_->detach(node);
    if (parent != kNone) {
        append_index(state_->element("nodes", parent), "children", node);
    } else if (JsonText* scene = state_->scene()) {
        append_index(*scene, "nodes", node);
    }
}

void GltfDocument::remove_node(std::size_t node) {
    state_->element("nodes", node);
    if (state_->count("scenes") == 0) {  // a scene is needed that does not show it
        JsonText scene("{}");
        for (std::size_t i = 0; i < node_count(); ++i) {
            if (i != node && state_->parent_of(i) == kNone) {
                append_index(scene, "nodes", i);
            }
        }
        state_->append("scenes", std::move(scene));
        state_->root.set("scene", JsonText("0"));
    }
    state_->detach(node);
}

}  // namespace lanthorn
