// A scene as a new document.
#include <algorithm>
#include <map>

#include "engine/assets/gltf_document_state.h"

namespace lanthorn {

namespace {

using Json = nlohmann::json;

// Sorted members, shortest numbers.
JsonText canonical(const JsonText& root) {
    Json document = parsed(root);
    if (const auto used = document.find("extensionsUsed"); used != document.end()) {
        std::sort(used->begin(), used->end());
    }
    return JsonText(document.dump());
}

class SceneWriter {
  public:
    SceneWriter(const SceneData& scene, GltfDocument& document) : scene_(scene), document_(document) {}

    void add_all() {
        for (const Image& image : scene_.images) {
            document_.add_image(image);
        }
        for (const Texture& texture : scene_.textures) {
            document_.add_texture(texture);
        }
        for (const Material& material : scene_.materials) {
            document_.add_material(material);
        }
        for (const Camera& camera : scene_.cameras) {
            document_.add_camera(camera);
        }
        for (const Light& light : scene_.lights) {
            document_.add_light(light);
        }
        for (const NodeData& node : scene_.nodes) {
            add(node);
        }
        for (const Skin& skin : scene_.skins) {
            document_.add_skin(skin);
        }
        for (const AnimationClip& clip : scene_.animations) {
            document_.add_animation(clip);
        }
    }

  private:
    void add(const NodeData& node) {
        const std::size_t index = document_.add_node(node.name, node.parent);
        document_.set_transform(index, node.local, node.shear);
        if (!node.meshes.empty()) {
            document_.set_node_mesh(index, mesh_of(node.meshes));
        }
        document_.set_node_camera(index, node.camera);
        // Skies are not written, and suns are parts of them.
        const bool sun =
            node.parent < scene_.nodes.size() && scene_.nodes[node.parent].sky < scene_.skies.size();
        if (!sun) {
            document_.set_node_light(index, node.light);
        }
    }

    // A glTF mesh is a list of primitives: one for every different list of the nodes.
    std::uint32_t mesh_of(const std::vector<std::uint32_t>& list) {
        const auto [known, added] = meshes_.try_emplace(list, 0);
        if (added) {
            std::vector<const Mesh*> primitives;
            primitives.reserve(list.size());
            for (const std::uint32_t mesh : list) {
                primitives.push_back(&scene_.meshes.at(mesh));
            }
            known->second = static_cast<std::uint32_t>(document_.add_mesh(primitives));
        }
        return known->second;
    }

    const SceneData& scene_;
    GltfDocument& document_;
    std::map<std::vector<std::uint32_t>, std::uint32_t> meshes_;
};

}  // namespace

GltfDocument GltfDocument::of_scene(const SceneData& scene, std::string_view generator) {
    GltfDocument document;
    State& state = *document.state_;
    state.root.find("asset")->set("generator", JsonText(json_quoted(generator)));
    SceneWriter(scene, document).add_all();
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const NodeData& node = scene.nodes[i];
        document.set_node_skin(i, node.skin);
        if (!node.extras.empty()) {
            document.set_extras(i, node.extras);
        }
        if (!node.morph_weights.empty()) {
            Json weights = Json::array();
            for (const float weight : node.morph_weights) {
                weights.push_back(plain_number(weight));
            }
            state.element("nodes", i).set("weights", JsonText(weights.dump()));
        }
    }
    state.root = canonical(state.root);
    return document;
}

}  // namespace lanthorn
