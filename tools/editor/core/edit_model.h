// The scene that is edited, as plain data: what the commands alter. World and document follow it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/assets/gltf_document.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::editor {

// A node of the document that stands in its default scene.
struct ModelNode {
    std::string name;                       // empty: it has none
    std::uint32_t parent = kNone;           // index of a node; kNone: a root
    std::vector<std::uint32_t> children{};  // in their order
    Transform local{};
    mat3 shear{1};
    std::uint32_t mesh = kNone, camera = kNone, light = kNone, skin = kNone;  // the document's indices
    std::string extras{};  // JSON text with sorted keys; empty: none
    bool visible = true;   // KHR_node_visibility of its own; one above may hide it all the same
    // The file's node that it shows, itself or what it was copied from, by index into SceneAsset::nodes;
    // kNone: none.
    std::uint32_t loaded = kNone;
    bool made = false;  // by a command
};

// Values are shared between copies, so that a copy costs a pointer an entry. An entry that is altered is
// replaced: what two models differ in is found by comparing pointers.
struct EditModel {
    // By the document's index, which never changes: removed nodes leave null. Null as well: a node of
    // another scene of the file.
    std::vector<std::shared_ptr<const ModelNode>> nodes;
    std::vector<std::uint32_t> roots;                    // in their order
    std::vector<std::shared_ptr<const Light>> lights;    // of KHR_lights_punctual; null: no node has it
    std::vector<std::shared_ptr<const Camera>> cameras;  // null likewise
    // Textures are those of the world's AssetStore and stay. Null: not used in the scene.
    std::vector<std::shared_ptr<const Material>> materials;

    // By the document's skin: the nodes that pose it.
    std::shared_ptr<const std::vector<std::vector<std::uint32_t>>> joints;

    // Null for an index that is not in the scene.
    const ModelNode* find(std::uint32_t node) const {
        return node < nodes.size() ? nodes[node].get() : nullptr;
    }
    // Throws InputError for an index that is not in the scene.
    const ModelNode& node(std::uint32_t node) const;
    // A copy to write, which takes the node's place.
    ModelNode& alter(std::uint32_t node);
    const std::vector<std::uint32_t>& children_of(std::uint32_t node) const;  // kNone: the roots
    bool is_within(std::uint32_t node, std::uint32_t above) const;            // or the same
    bool is_shown(std::uint32_t node) const;  // neither it nor one above is hidden
    dmat4 world_matrix(std::uint32_t node) const;
    // All that stand in the scene, parents before children, in the importer's order.
    std::vector<std::uint32_t> in_order() const;
    std::size_t node_count() const;  // that stand in the scene. O(nodes)
};

// What of a file's scene can be edited. `scene` was imported from what `document` holds.
EditModel model_of(const SceneData& scene, const GltfDocument& document);

// The light and the value of a node that has them; null: it has none.
const Light* light_of(const EditModel& model, std::uint32_t node);

// Whether the node's extras have that member.
bool has_extra(const ModelNode& node, const char* key);

// The rotation as it is read again once it has been written to a file: unit length, and the same bits.
quat written_rotation(const quat& rotation);

}  // namespace lanthorn::editor
