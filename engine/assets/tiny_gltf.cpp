// The one place where tinygltf's code is compiled, so that sanitizers see it too.
#define TINYGLTF_IMPLEMENTATION
#include "engine/assets/tiny_gltf.h"

namespace lanthorn {

namespace {

using nlohmann::json;

// One value of `T` for each element of a top-level array, by tinygltf's own function for one. False, with
// `error`, at the first that it refuses.
template <class T, class Parse>
bool load_all(const json& root, const char* key, std::vector<T>& into, const Parse& parse) {
    const auto found = root.find(key);
    if (found == root.end()) {
        return true;
    }
    into.reserve(found->size());
    for (const json& element : *found) {
        if (!element.is_object() || !parse(&into.emplace_back(), element)) {
            return false;
        }
    }
    return true;
}

bool load_lights(const json& root, std::vector<tinygltf::Light>& lights, std::string* error) {
    static const json::json_pointer kLights("/extensions/KHR_lights_punctual");
    return !root.contains(kLights) ||
           load_all(root[kLights], "lights", lights, [&](tinygltf::Light* light, const json& from) {
               return tinygltf::ParseLight(light, error, from, false);
           });
}

}  // namespace

bool load_parsed(const json& root, tinygltf::Model& model, std::string& error) {
    std::string* const e = &error;
    const bool loaded =
        load_all(root, "bufferViews", model.bufferViews,
                 [&](auto* to, const json& o) { return tinygltf::ParseBufferView(to, e, o, false); }) &&
        load_all(root, "accessors", model.accessors,
                 [&](auto* to, const json& o) { return tinygltf::ParseAccessor(to, e, o, false); }) &&
        load_all(root, "meshes", model.meshes,
                 [&](auto* to, const json& o) { return tinygltf::ParseMesh(to, &model, e, o, false); }) &&
        load_all(root, "nodes", model.nodes,
                 [&](auto* to, const json& o) { return tinygltf::ParseNode(to, e, o, false); }) &&
        load_all(root, "scenes", model.scenes,
                 [&](tinygltf::Scene* to, const json& o) {
                     tinygltf::ParseStringProperty(&to->name, e, o, "name", false);
                     return tinygltf::ParseIntegerArrayProperty(&to->nodes, e, o, "nodes", false) ||
                            !o.contains("nodes");
                 }) &&
        load_all(root, "materials", model.materials,
                 [&](auto* to, const json& o) { return tinygltf::ParseMaterial(to, e, o, false); }) &&
        load_all(root, "textures", model.textures,
                 [&](auto* to, const json& o) { return tinygltf::ParseTexture(to, e, o, false, ""); }) &&
        load_all(root, "samplers", model.samplers,
                 [&](auto* to, const json& o) { return tinygltf::ParseSampler(to, e, o, false); }) &&
        load_all(root, "cameras", model.cameras,
                 [&](auto* to, const json& o) { return tinygltf::ParseCamera(to, e, o, false); }) &&
        load_lights(root, model.lights, e);
    model.defaultScene = root.value("scene", -1);
    return loaded;
}

}  // namespace lanthorn
