// The world that shows a model: entities follow its nodes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/ecs/component_json.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/scene/scene_asset.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/editor/core/edit_model.h"

namespace lanthorn::editor {

// Which node an entity shows: the link between world and document.
struct EditedNode {
    std::uint32_t node = kNone;    // of the document; kNone: made by the importer, or lent
    std::uint32_t loaded = kNone;  // into SceneAsset::nodes; kNone: made by a command
    bool guest = false;            // of the light that is lent to a file without any
};

// Entities stand in the order in which a program that opens the saved file would make them, so that what
// depends on their order (which light comes first) is the game's.
class EditWorld {
  public:
    // Declares EditedNode. The App has the plugins of scenes.
    explicit EditWorld(App& app);

    // Shows another file: what was shown goes. `own` nodes of `scene` are the file's and the importer's,
    // those behind them are lent. Its materials, with the store's textures, are put into `model`.
    void load(SceneData scene, std::size_t own, EditModel& model, const workbench::SceneView& view);
    // Shows another model of the same file. Values are put in place: O(nodes) to find them. Where nodes came,
    // went or were put under others all entities are made again: O(nodes).
    void show(const EditModel& model);
    // That second of a clip of the file from the next frame on; `clip` as play_clip() takes it, null: what
    // the file begins with. What another clip moved stands as the model has it, materials aside. Throws
    // InputError for a clip that is none; nothing has changed then.
    void show_moment(const std::optional<std::string>& clip, double seconds);
    const std::optional<std::string>& clip() const { return clip_; }
    // What is lent is another light: nodes behind the first `own` of `scene`, or none. O(entities).
    void lend(const SceneData& scene, std::size_t own);

    ecs::Entity entity_of(std::uint32_t node) const;  // null: none. O(entities)
    std::uint32_t node_of(ecs::Entity e) const;       // kNone: none
    std::vector<ecs::Entity> entities() const;        // by node
    std::vector<ecs::Entity> guests() const;
    MaterialHandle material(std::uint32_t index) const;
    // Of the contents of a mesh of the document; 0: none of it is shown.
    std::uint64_t mesh_hash(std::uint32_t mesh) const;
    const SceneAsset& asset() const;
    // The importer has put the node's meshes into nodes of their own (EXT_mesh_gpu_instancing).
    bool is_instanced(std::uint32_t loaded) const;

    // A node that is lent, with what hangs on it.
    struct Guest {
        NodeData node;  // `light` and `sky` only say whether there is one
        Light light;
        Sky sky;
    };
    const std::vector<Guest>& lent() const { return guests_; }
    bool has_sky() const;  // of the file

  private:
    void spawn_all();
    void destroy_all();
    ecs::Entity spawn_loaded(std::uint32_t loaded, ecs::Entity parent);
    ecs::Entity spawn_node(std::uint32_t node, ecs::Entity parent);
    void spawn_guests();
    std::vector<ecs::Entity> by_loaded() const;  // kNullEntity: none is left
    void put_skins();
    void put_clips();
    void play_wanted();  // the clip that is asked for, or that the file names
    void put_node(ecs::Entity e, std::uint32_t node);
    void put_extras(ecs::Entity e, const std::string& extras, const ecs::EntityNames& names);
    ecs::EntityNames names() const;
    void put_values(const EditModel& before);
    bool alters_instances(const EditModel& before) const;
    void take_guests(const SceneData& scene, std::size_t own);

    App& app_;
    EditModel model_;
    SceneHandle scene_;
    AssetHold<SceneAsset> held_;
    std::string animation_, source_;
    std::optional<std::string> clip_;                     // asked for instead of animation_
    std::string playing_;                                 // as play_clip() took it
    std::vector<std::uint32_t> made_roots_;               // importer's nodes without a parent
    std::vector<std::vector<std::uint32_t>> made_below_;  // by loaded node: those that the importer made
    std::vector<Guest> guests_;
    std::vector<std::uint64_t> mesh_hashes_;  // by the document's mesh
};

}  // namespace lanthorn::editor
