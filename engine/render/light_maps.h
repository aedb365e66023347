// What every light sees: shadow map and photon emission map in one rendering (a reflective shadow map,
// Dachsbacher and Stamminger 2005).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/gpu/buffer.h"
#include "engine/gpu/framebuffer.h"
#include "engine/gpu/texture.h"
#include "engine/render/emissive.h"
#include "engine/render/gpu_scene.h"
#include "engine/render/light_data.h"
#include "engine/render/render_settings.h"
#include "engine/render/scene_program.h"

namespace lanthorn::render {

class LightMaps {
  public:
    LightMaps();

    // Brings lights and maps up to date: a map is drawn again only if its light changed or geometry changed
    // where the light can reach. Both sides of every surface block light.
    void update(const FrameScene& scene, const GpuScene& gpu_scene, const EmissiveTriangles& emissive,
                const RenderSettings& settings);

    // LightData: punctual lights in the order of FrameScene::lights, then area samples. Bind at
    // kLightsBinding.
    const gpu::Buffer& lights() const { return light_buffer_; }
    std::span<const LightData> light_data() const { return lights_; }
    int light_count() const { return static_cast<int>(lights_.size()); }
    int punctual_count() const { return punctual_count_; }

    // Arrays of resolution() squared times the punctual lights' layers; layers as LightData says.
    // R32F: metres from the light (directional: from the map's near plane); 0 where nothing is seen.
    const gpu::Texture& distance() const { return punctual_.distance; }
    // RG16_SNORM: octahedral geometric normal, facing the light.
    const gpu::Texture& normals() const { return punctual_.normals; }
    // RGBA16F: diffuse albedo, textures included; a = 1 where something is seen.
    const gpu::Texture& albedo() const { return punctual_.albedo; }
    int resolution() const { return punctual_.resolution; }

    // The area samples' cubes, area_resolution() squared; shadows alone.
    const gpu::Texture& area_distance() const { return area_.distance; }
    const gpu::Texture& area_normals() const { return area_.normals; }
    int area_resolution() const { return area_.resolution; }

    int layers_drawn() const { return layers_drawn_; }  // by the last update
    std::uint64_t version() const { return version_; }  // grows whenever a light or map changes
    std::string reload_if_changed();

  private:
    struct Maps {
        int resolution = 0;
        int layers = 0;
        gpu::Texture distance;
        gpu::Texture normals;                        // punctual maps alone
        gpu::Texture albedo;                         // punctual maps alone
        gpu::Texture depth;                          // one layer, shared
        std::vector<gpu::Framebuffer> framebuffers;  // by layer

        // Returns whether the maps are new and empty.
        bool allocate(int new_resolution, int new_layers, bool with_albedo);
    };
    // Draws all layers of a light's map, or those that see `dirty`.
    void draw_light(std::size_t index, const FrameScene& scene, const GpuScene& gpu_scene, const Aabb* dirty);

    SceneProgram program_;
    SceneProgram area_program_;
    Maps punctual_;
    Maps area_;
    std::vector<LightData> lights_;
    std::vector<LightData> area_samples_;
    std::vector<std::uint32_t> visible_;
    std::uint64_t emissive_version_ = ~0ull;
    std::uint64_t last_frame_ = ~0ull - 1;
    RenderSettings settings_;
    gpu::Buffer light_buffer_;
    int punctual_count_ = 0;
    int layers_drawn_ = 0;
    std::uint64_t version_ = 0;
};

}  // namespace lanthorn::render
