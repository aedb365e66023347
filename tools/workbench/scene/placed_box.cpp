#include "tools/workbench/scene/placed_box.h"

#include <string>

#include "lanthorn/workbench/motions.h"

namespace lanthorn::workbench {

namespace {

constexpr float kGrey = 0.7f;  // reflectance

std::uint32_t add_matte(SceneData& scene, const std::string& name, float reflectance) {
    Material material;
    material.name = name;
    material.base_colour = vec4(vec3(reflectance), 1);
    material.metallic = 0;
    material.roughness = 1;
    material.specular = 0;
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

// About the origin, four corners a face.
Mesh cube(float side) {
    Mesh mesh;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        vec3 normal(0), u(0), v(0);
        normal[axis] = face % 2 == 0 ? -1.0f : 1.0f;
        u[(axis + 1) % 3] = 1;
        v = glm::cross(normal, u);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const vec3& corner : {-u - v, u - v, u + v, -u + v}) {
            Vertex vertex;
            vertex.position = 0.5f * side * (normal + corner);
            vertex.normal = normal;
            mesh.vertices.push_back(vertex);
            mesh.bounds.add(vertex.position);
        }
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) {
            mesh.indices.push_back(first + corner);
        }
    }
    return mesh;
}

}  // namespace

void place_box(SceneData& scene, const PlacedBox& box) {
    Mesh mesh = cube(static_cast<float>(box.side));
    mesh.name = kBoxName;
    mesh.material = add_matte(scene, kBoxName, kGrey);
    scene.meshes.push_back(std::move(mesh));
    NodeData node;
    node.name = kBoxName;
    node.local.translation = box.centre;
    node.meshes = {static_cast<std::uint32_t>(scene.meshes.size() - 1)};
    scene.nodes.push_back(std::move(node));
}

}  // namespace lanthorn::workbench
