// A loaded scene as plain data: what an importer yields and what is spawned into a world.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/scene/animation_clip.h"
#include "lanthorn/scene/camera.h"
#include "lanthorn/scene/light.h"
#include "lanthorn/scene/material.h"
#include "lanthorn/scene/mesh.h"
#include "lanthorn/scene/skin.h"
#include "lanthorn/scene/sky.h"

namespace lanthorn {

inline constexpr std::uint32_t kNone = 0xffffffffu;

// Translation in double precision, so that a scene 1000 km from its origin still is exact to a nanometre.
struct Transform {
    dvec3 translation{0};
    quat rotation{1, 0, 0, 0};  // w, x, y, z; unit length
    vec3 scale{1};

    dmat4 matrix() const;  // T * R * S, in double precision
    bool operator==(const Transform&) const = default;
};

// A node of the scene, and what hangs on it.
struct NodeData {
    std::string name;
    std::uint32_t parent = kNone;  // index of the parent node, always smaller than this node's own index
    Transform local;  // TRS; a glTF matrix is decomposed (a shear it cannot hold is kept in `shear`)
    mat3 shear{1};    // applied before scale: local = T * R * S * shear; identity for TRS nodes
    std::vector<std::uint32_t> meshes;  // indices into SceneData::meshes, one a primitive
    std::uint32_t camera = kNone;       // index into SceneData::cameras
    std::uint32_t light = kNone;        // index into SceneData::lights
    std::uint32_t skin = kNone;         // index into SceneData::skins; only with meshes
    std::uint32_t sky = kNone;          // index into SceneData::skies
    std::vector<float> morph_weights;   // the node's own `weights`; empty: the mesh's
    std::string extras;                 // the node's `extras` as JSON text; empty if absent
};

// Where the parts of a scene stand in the file that they came from: indices into the file's own arrays, as
// GltfDocument counts them. kNone: nowhere, the importer made it. All are empty in a scene that came from no
// file.
struct FileMap {
    // A primitive of the file: its mesh's index there, and its own in that mesh.
    struct Primitive {
        std::uint32_t mesh = kNone, primitive = kNone;
        bool operator==(const Primitive&) const = default;
    };
    std::vector<std::uint32_t> nodes;      // by index into SceneData::nodes; kNone: an instance, a sky, a sun
    std::vector<std::uint32_t> cameras;    // by index into SceneData::cameras
    std::vector<std::uint32_t> lights;     // likewise; of KHR_lights_punctual
    std::vector<std::uint32_t> materials;  // likewise
    std::vector<std::uint32_t> textures;   // likewise
    std::vector<std::uint32_t> images;     // likewise; of several that are one picture the first
    std::vector<Primitive> meshes;         // likewise
};

struct SceneData {
    std::string source;           // file the scene came from
    FileMap file;                 // and where in it
    std::vector<NodeData> nodes;  // parents before children
    std::vector<Mesh> meshes;
    std::vector<Material> materials;  // at least one: index 0 may be glTF's default material
    std::vector<Texture> textures;
    std::vector<Image> images;
    std::vector<Camera> cameras;
    std::vector<Light> lights;
    std::vector<Sky> skies;
    std::vector<Skin> skins;
    std::vector<AnimationClip> animations;
    std::vector<std::string> warnings;  // damage that was confined, each one line: place and what was done

    std::uint64_t triangle_count() const;  // over the meshes, not the instances
};

}  // namespace lanthorn
