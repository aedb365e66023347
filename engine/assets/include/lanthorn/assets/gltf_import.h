// glTF 2.0 import: .gltf and .glb files to plain scene data.
#pragma once

#include <filesystem>
#include <string>

#include "lanthorn/assets/import_budget.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// How a file is read, and what it may take.
struct GltfOptions {
    // Of KHR_materials_variants, the one whose materials are used; empty: the materials that primitives name.
    std::string variant;
    // Whether buffers and images may lie outside of the file's folder. A stranger's file that names one there
    // is refused (a buffer) or goes without it (an image).
    bool allow_outside = false;
    // What the file may take.
    ImportBudget budget{};
};

// Loads the default scene of a glTF 2.0 file (scene 0 if it names none, all root nodes if it has no scenes).
//
// Read: nodes, meshes of triangles (lists, strips, fans), points and lines (as thin surfaces, with a
// warning), materials and textures, cameras, punctual lights, skins, morph targets, animations, the nodes'
// extras, and subdivision cages in the extras of meshes and primitives (see gltf_deformation.h); the
// extensions EXT_lights_image_based (as a sky in a node of its own, with directional lights for the suns in
// it), EXT_mesh_gpu_instancing (a node an instance), EXT_meshopt_compression, EXT_texture_webp,
// KHR_animation_pointer (to nodes), KHR_draco_mesh_compression, KHR_lights_punctual,
// KHR_materials_{clearcoat,sheen} (their share of the light, see gltf_material_layers.h),
// KHR_materials_{emissive_strength,ior,pbrSpecularGlossiness,specular,transmission,unlit,variants,volume},
// KHR_mesh_quantization, KHR_node_visibility, KHR_texture_transform. Others that the file uses are reported
// once. Meshes, skins and images that nothing in the scene uses are not loaded.
//
// Every float of the result is finite, every normal and tangent has unit length, every index is in range.
//
// Throws InputError, one line "FILE: JSON POINTER: PROBLEM", for what cannot be read as meant: a missing or
// truncated file, wrong types, references or ranges that lead nowhere, NaN positions, nodes that are their
// own ancestors, an unknown required extension that changes more than looks, compressed data that is damaged.
// Damage that can be confined is: it is repaired and reported in SceneData::warnings. A broken or missing
// *image* is left out of its materials, as if they had no such texture; images wider or higher than 16384 are
// scaled down; factors out of range are clamped; zero normals and tangents are replaced; vertices without
// weights are bound to joint 0; animation channels with impossible keys, wrong counts or a target outside the
// scene are left out; cages that are wrong are not subdivided; a node that a scene lists though it has a
// parent is shown once, under a listed ancestor or else as a root; a node with two parents stays with the
// first; names in Latin-1 become UTF-8. Equal warnings are reported once, with the number of places. What a
// file makes of itself is held to a budget before memory is taken (import_budget.h), and what would take time
// out of all proportion is cut (scene_budget.h).
//
// Thread-safe. Decodes images on all cores.
SceneData import_gltf(const std::filesystem::path& path, const GltfOptions& options = {});

}  // namespace lanthorn
