// glTF 2.0 import: .gltf and .glb files to plain scene data.
#pragma once

#include <filesystem>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// Loads the default scene of a glTF 2.0 file (scene 0 if it names none, all root nodes if it has no scenes).
//
// Read: nodes, meshes of triangles (lists, strips, fans; points and lines are left out with a warning),
// materials and textures, cameras, punctual lights, skins, morph targets, animations, the nodes' extras, and
// subdivision cages in the extras of meshes and primitives (see gltf_deformation.h); the extensions
// EXT_lights_image_based (as a sky in a node of its own, with directional lights for the suns in it),
// KHR_lights_punctual, KHR_materials_{emissive_strength,ior,specular,transmission,unlit},
// KHR_mesh_quantization, KHR_texture_transform. Meshes, skins and images that nothing in the scene uses are
// not loaded.
//
// Every float of the result is finite, every normal and tangent has unit length, every index is in range.
//
// Throws InputError, one line "FILE: JSON POINTER: PROBLEM", for what cannot be read as meant: a missing or
// truncated file, wrong types, references or ranges that lead nowhere, NaN positions, nodes that form no
// tree, an unknown required extension. Damage that can be confined is: it is mended and told in
// SceneData::warnings. A broken or missing *image* is left out of its materials, as if they had no such
// texture; images wider or higher than 16384 are scaled down; factors out of range are clamped; zero normals
// and tangents are replaced; vertices without weights are bound to joint 0; animation channels with
// impossible keys, wrong counts or a target outside the scene are left out; cages that are wrong are not
// subdivided; a node that a scene lists though it has a parent is shown once, under a listed ancestor or else
// as a root.
//
// Thread-safe. Decodes images on all cores.
SceneData import_gltf(const std::filesystem::path& path);

}  // namespace lanthorn
