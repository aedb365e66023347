#include "tools/lanthorn/inspect/scene_contents.h"

namespace lanthorn::tools {

std::vector<dmat4> world_matrices(const SceneData& scene) {
    std::vector<dmat4> world;
    for (const NodeData& node : scene.nodes) {
        const dmat4 local = node.local.matrix() * dmat4(glm::dmat3(node.shear));
        world.push_back(node.parent == kNone ? local : world[node.parent] * local);
    }
    return world;
}

WorldBox world_bounds(const SceneData& scene, const std::vector<dmat4>& world) {
    WorldBox box;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        for (const std::uint32_t mesh : scene.nodes[i].meshes) {
            for (const Vertex& vertex : scene.meshes[mesh].vertices) {
                const dvec3 p = dvec3(world[i] * dvec4(dvec3(vertex.position), 1));
                box.lower = glm::min(box.lower, p);
                box.upper = glm::max(box.upper, p);
            }
        }
    }
    return box;
}

std::uint64_t placed_triangles(const SceneData& scene) {
    std::uint64_t placed = 0;
    for (const NodeData& node : scene.nodes) {
        for (const std::uint32_t mesh : node.meshes) {
            placed += scene.meshes[mesh].indices.size() / 3;
        }
    }
    return placed;
}

const char* light_type_name(LightType type) {
    constexpr const char* kNames[] = {"directional", "point", "spot"};
    return kNames[static_cast<int>(type)];
}

std::array<std::pair<const TextureRef*, const char*>, 8> named_textures(const Material& m) {
    return {{{&m.base_colour_texture, "base colour"},
             {&m.metallic_roughness_texture, "metallic-roughness"},
             {&m.normal_texture, "normal"},
             {&m.occlusion_texture, "occlusion"},
             {&m.emissive_texture, "emissive"},
             {&m.specular_texture, "specular"},
             {&m.specular_colour_texture, "specular colour"},
             {&m.transmission_texture, "transmission"}}};
}

}  // namespace lanthorn::tools
