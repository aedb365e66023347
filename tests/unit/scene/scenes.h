// Small scenes for the tests of this folder.
#pragma once

#include "lanthorn/scene/scene_data.h"

namespace scene_test {

using namespace lanthorn;

// The unit cube's corners and two triangles of it: enough for bounds.
inline Mesh cube() {
    Mesh mesh;
    mesh.name = "cube";
    for (int i = 0; i < 8; ++i) {
        Vertex v;
        v.position = vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        mesh.vertices.push_back(v);
        mesh.bounds.add(v.position);
    }
    mesh.indices = {0, 1, 2, 1, 3, 2};
    return mesh;
}

inline NodeData node(std::string name, dvec3 at, std::uint32_t parent = kNone) {
    NodeData n;
    n.name = std::move(name);
    n.local.translation = at;
    n.parent = parent;
    return n;
}

// A table with a lamp (light, camera) on it, and a ball beside it.
inline SceneData room() {
    SceneData scene;
    scene.meshes = {cube()};
    scene.materials.resize(1);
    scene.lights.resize(1);
    scene.cameras.resize(1);
    scene.nodes = {node("table", {10, 0, 0}), node("lamp", {0, 2, 0}, 0), node("ball", {20, 0, 0})};
    scene.nodes[0].meshes = {0};
    scene.nodes[1].light = 0;
    scene.nodes[1].camera = 0;
    scene.nodes[2].meshes = {0};
    return scene;
}

}  // namespace scene_test
