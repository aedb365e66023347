// A room to begin with.
#include <algorithm>

#include "lanthorn/scene/scene_data.h"
#include "tools/editor/core/light_units.h"
#include "tools/editor/core/session_state.h"

namespace lanthorn::editor {

namespace {

// A rectangle from `at` along `u` and `v`; its front is on the side of cross(u, v).
Mesh rectangle(const vec3& at, const vec3& u, const vec3& v, std::uint32_t material) {
    Mesh mesh;
    const vec3 normal = glm::normalize(glm::cross(u, v));
    for (int i = 0; i < 4; ++i) {
        const vec2 uv(i == 1 || i == 2 ? 1 : 0, i >= 2 ? 1 : 0);
        Vertex vertex;
        vertex.position = at + uv.x * u + uv.y * v;
        vertex.normal = normal;
        vertex.tangent = vec4(glm::normalize(u), 1);
        vertex.uv0 = uv;
        mesh.vertices.push_back(vertex);
        mesh.bounds.add(vertex.position);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = material;
    return mesh;
}

Material paint(const char* name, const vec3& colour) {
    Material material;
    material.name = name;
    material.base_colour = vec4(colour, 1);
    material.metallic = 0;
    material.roughness = 0.8f;
    return material;
}

void add(SceneData& scene, const char* name, Mesh mesh) {
    NodeData node;
    node.name = name;
    node.parent = 0;
    mesh.name = name;
    node.meshes = {static_cast<std::uint32_t>(scene.meshes.size())};
    scene.meshes.push_back(std::move(mesh));
    scene.nodes.push_back(std::move(node));
}

}  // namespace

GltfDocument room_document() {
    constexpr float kX = 3, kY = 3, kZ = 2;  // half the length, the height, half the width; metres
    SceneData scene;
    scene.materials = {paint("floor", vec3(0.35f, 0.27f, 0.2f)), paint("walls", vec3(0.7f)),
                       paint("red wall", vec3(0.6f, 0.12f, 0.08f))};
    NodeData room;
    room.name = "room";
    scene.nodes.push_back(room);
    const vec3 x(2 * kX, 0, 0), y(0, kY, 0), z(0, 0, 2 * kZ);
    add(scene, "floor", rectangle({-kX, 0, kZ}, x, -z, 0));
    add(scene, "ceiling", rectangle({-kX, kY, -kZ}, x, z, 1));
    add(scene, "north wall", rectangle({-kX, 0, -kZ}, x, y, 1));
    add(scene, "south wall", rectangle({kX, 0, kZ}, -x, y, 1));
    add(scene, "west wall", rectangle({-kX, 0, kZ}, -z, y, 2));
    add(scene, "east wall", rectangle({kX, 0, -kZ}, z, y, 1));
    Light light;
    light.intensity = 80;
    light.colour = colour_of_kelvin(3000);
    light.colour /= std::max({light.colour.x, light.colour.y, light.colour.z});
    scene.lights.push_back(light);
    NodeData lamp;
    lamp.name = "lamp";
    lamp.parent = 0;
    lamp.light = 0;
    lamp.local.translation = {0, 2.4, 0};
    scene.nodes.push_back(lamp);
    return GltfDocument::of_scene(scene, "lanthorn edit");
}

}  // namespace lanthorn::editor
