#include "tests/unit/assets/file_map.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "lanthorn/assets/gltf_document.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn {
namespace {

using nlohmann::json;

// The nodes of the scene that is loaded.
std::set<std::uint32_t> nodes_of_scene(const json& document) {
    std::vector<std::uint32_t> pending;
    if (document.contains("scenes") && !document["scenes"].empty()) {
        pending = document["scenes"][document.value("scene", 0u)].value("nodes", pending);
    } else {
        std::set<std::uint32_t> children;
        const json nodes = document.value("nodes", json::array());
        for (const json& node : nodes) {
            for (const std::uint32_t child : node.value("children", std::vector<std::uint32_t>())) {
                children.insert(child);
            }
        }
        for (std::uint32_t i = 0; i < nodes.size(); ++i) {
            if (!children.contains(i)) {
                pending.push_back(i);
            }
        }
    }
    std::set<std::uint32_t> found;
    while (!pending.empty()) {
        const std::uint32_t node = pending.back();
        pending.pop_back();
        if (found.insert(node).second) {
            for (const std::uint32_t child :
                 document["nodes"][node].value("children", std::vector<std::uint32_t>())) {
                pending.push_back(child);
            }
        }
    }
    return found;
}

std::uint32_t light_of(const json& node) {
    const json::json_pointer place("/extensions/KHR_lights_punctual/light");
    return node.contains(place) ? node[place].get<std::uint32_t>() : kNone;
}

void expect_node(const FilePlace& place, const json& node) {
    EXPECT_EQ(place.camera, node.value("camera", kNone));
    EXPECT_EQ(place.light, light_of(node));
    for (const FileMap::Primitive& primitive : place.meshes) {
        EXPECT_EQ(primitive.mesh, node.value("mesh", kNone));
    }
}

}  // namespace

void expect_file_map(const std::filesystem::path& file) {
    SCOPED_TRACE(file);
    ecs::World world;
    const SceneHandle scene = asset_store(world).add(import_gltf(file));
    const std::vector<ecs::Entity> entities = spawn(world, scene);
    const GltfDocument document = GltfDocument::open(file);
    const json root = json::parse(document.json_text());
    std::set<std::uint32_t> found;
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const FilePlace place = file_place(world, entities[i]);
        if (place.node == kNone) {
            continue;
        }
        EXPECT_TRUE(found.insert(place.node).second) << place.node;
        const Name* name = world.try_get<Name>(entities[i]);
        EXPECT_EQ(name != nullptr ? name->value : "", document.node_name(place.node));
        expect_node(place, root["nodes"][place.node]);
        if (i % (1 + entities.size() / 50) == 0) {  // O(entities) each
            EXPECT_EQ(entities_at(world, scene, &FilePlace::node, place.node), std::vector{entities[i]});
        }
    }
    EXPECT_EQ(found, nodes_of_scene(root));
    const SceneAsset& asset = asset_store(world).get(scene);
    for (std::uint32_t i = 0; i < document.material_count(); ++i) {
        const MaterialHandle material = material_at(asset, i);
        ASSERT_TRUE(material) << i;
        EXPECT_EQ(asset_store(world).get(material).name, root["materials"][i].value("name", ""));
        EXPECT_EQ(file_index(asset, material), i);
    }
    for (std::uint32_t i = 0; i < document.light_count(); ++i) {
        for (const ecs::Entity lit : entities_at(world, scene, &FilePlace::light, i)) {
            EXPECT_EQ(light_of(root["nodes"][file_place(world, lit).node]), i);
        }
    }
}

}  // namespace lanthorn
