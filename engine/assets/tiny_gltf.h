// tinygltf as this project uses it: JSON to structures only. Files, buffers and images are read by our own
// code, which checks them; stb is left out.
#pragma once

#include <nlohmann/json.hpp>

#define TINYGLTF_NO_INCLUDE_JSON
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

#include <string>

namespace lanthorn {

// Fills the model's buffer views, accessors, meshes, nodes, scenes, materials, textures, samplers, cameras
// and lights from JSON that is parsed already. TinyGLTF takes text alone, and would parse it a second time:
// this calls the functions of its implementation (2.5 to 2.8) that it calls for one element each. False, with
// `error`, for what they refuse.
bool load_parsed(const nlohmann::json& root, tinygltf::Model& model, std::string& error);

}  // namespace lanthorn
