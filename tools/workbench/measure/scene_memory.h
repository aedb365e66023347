// Where the megabytes of a scene that is shown go: asset by asset, and by what frames keep.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/gi/statistics.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/scene/frame_scene.h"
#include "lanthorn/workbench/frame_meter.h"

namespace lanthorn::workbench {

// A mesh or an image.
struct AssetBytes {
    std::string name;
    std::string size;       // "1 024 triangles", "512x512"
    std::uint64_t gpu = 0;  // as drawn: vertices and triangles, or texels with their mipmaps
    std::uint64_t cpu = 0;  // as the scene holds it
    bool operator==(const AssetBytes&) const = default;
};

// What a mesh has on the GPU, and for each instance of it that deforms once more; coarser shapes of what
// moves are not in it. O(meshes + instances).
std::vector<AssetBytes> mesh_bytes(const FrameScene& scene);
// What an image has on the GPU, mipmaps and all: once as colour, once as data, as materials use it; 0 where
// none does. O(materials + images).
std::vector<AssetBytes> image_bytes(const SceneAssets& assets);

struct SceneMemory {
    struct Part {
        std::string name, about;  // one word or two; what is in it
        std::uint64_t gpu = 0;    // bytes
    };
    std::vector<AssetBytes> meshes, images;  // most on the GPU first
    // All of the GPU's: meshes and images, then what frames keep; the last is the rest.
    std::vector<Part> parts;
    std::uint64_t gpu = 0;      // bytes of all buffers and textures, the sum of `parts`
    std::uint64_t process = 0;  // bytes that the process had in memory at most
    std::uint64_t lit_texels = 0, remembered_rays = 0;  // what the technique says that it keeps
    int maps = 0;                                       // environment maps
};

// After a frame, in its OpenGL context.
SceneMemory scene_memory(const FrameScene& scene, const render::FrameRenderer& renderer,
                         const gi::GiStatistics& statistics, const FrameMeter::Held& held);

}  // namespace lanthorn::workbench
