// What the parts of one import share.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "engine/assets/gltf_file.h"
#include "engine/assets/gltf_model.h"
#include "engine/assets/gltf_uv_sets.h"
#include "lanthorn/core/printable.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

struct GltfContext {
    const GltfFile& file;
    const tinygltf::Model& model;
    SceneData& scene;
    ImportBudget& left;            // of the whole file
    std::vector<UvSets>& uv_sets;  // by glTF material: what its textures ask for

    [[noreturn]] void refuse(std::string_view place, std::string_view problem) const {
        file.refuse(place, problem);
    }
    void warn(std::string_view place, std::string_view text) const {
        scene.warnings.push_back(printable(fmt::format("{}: {}", place, text)));
    }
    // `value` moved into low..high, with a warning if it was outside.
    float clamped(double value, double low, double high, std::string_view place) const;
};

// gltf_material.cpp
// Fills scene.materials, one for each glTF material and in the same order, and uv_sets with them.
void import_materials(const GltfContext& context);

// Decodes glTF images, on all cores; each failure is a `problem`, never an exception. What their headers
// state is held against the budget first, in this order; an image whose problem is not empty takes nothing.
struct DecodedImage;
std::vector<DecodedImage> load_images(const GltfContext& context, const std::vector<std::size_t>& indices);

// gltf_texture.cpp
// Fills scene.textures and scene.images with what the materials use, decodes the images, and removes from
// the materials the references to images that cannot be decoded. `TextureRef::texture` holds the glTF index
// before and the index into scene.textures after.
void import_textures(const GltfContext& context);

// The smallest skin that a mesh is used with.
struct JointLimit {
    std::size_t joints = 0;  // 0: the mesh is used without a skin
    std::size_t skin = 0;    // glTF index
};

// gltf_mesh.cpp
// Appends the triangle primitives of glTF mesh `mesh` to scene.meshes and returns their indices.
std::vector<std::uint32_t> import_mesh(const GltfContext& context, std::size_t mesh, const JointLimit& limit);

// For each glTF node its index in scene.nodes; kNone for those outside the scene that is loaded.
using NodeMap = std::vector<std::uint32_t>;

// gltf_node.cpp
// Fills scene.nodes, cameras and lights, and imports the meshes that the nodes use.
NodeMap import_nodes(const GltfContext& context);

// A quaternion x, y, z, w made unit; none, with a warning at `place`/rotation, where it is zero.
quat read_rotation(const GltfContext& context, const std::vector<double>& xyzw, const std::string& place);

// gltf_image_light.cpp
// Adds the image-based light of the scene that is loaded: a node with a sky, below it one for each sun. Where
// its images are damaged it is what the irradiance coefficients say, or left out, with a warning.
void import_image_light(const GltfContext& context);

// gltf_skin.cpp
// Fills scene.skins with those that the scene's nodes use, and NodeData::skin. A skin that cannot pose its
// meshes is left out with a warning.
void import_skins(const GltfContext& context, const NodeMap& nodes);

// gltf_animation.cpp
// Fills scene.animations. Channels that cannot be played are left out with a warning, and so are animations
// without any other.
void import_animations(const GltfContext& context, const NodeMap& nodes);

}  // namespace lanthorn
