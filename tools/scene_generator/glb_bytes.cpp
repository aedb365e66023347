#include "tools/scene_generator/glb_bytes.h"

#include "lanthorn/assets/gltf_document.h"

namespace lanthorn::scene_generator {

std::string glb_bytes(const SceneData& scene) {
    return GltfDocument::of_scene(scene, "lanthorn generate_scenes").glb_bytes();
}

}  // namespace lanthorn::scene_generator
