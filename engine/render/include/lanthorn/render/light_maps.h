// What every light sees: shadow map and photon emission map in one rendering (a reflective shadow map,
// Dachsbacher and Stamminger 2005).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/growing_buffer.h"
#include "lanthorn/render/emissive.h"
#include "lanthorn/render/gpu_scene.h"
#include "lanthorn/render/light_data.h"
#include "lanthorn/render/light_map_array.h"
#include "lanthorn/render/render_settings.h"
#include "lanthorn/render/scene_program.h"
#include "lanthorn/render/shining_lights.h"
#include "lanthorn/scene/scene_motion.h"

namespace lanthorn::render {

class LightMaps {
  public:
    // version() counts from `version` on.
    explicit LightMaps(std::uint64_t version = 0);

    // Brings lights and maps up to date, whatever happened since the last call. Both sides of every surface
    // block light.
    //
    // Cost: all faces of a light that came or moved. Of a light that stays where it is, the faces that see
    // what moves or moved, within its range: once for what stands still (kept as a separate layer while
    // anything in the scene moves, 12 or 20 bytes a texel; 256 MiB in all, faces beyond are drawn whole),
    // then a copy and the movers' triangles. Maps equal those drawn in full, bit by bit, but that of a mover
    // and something still at the very same depth the latter is seen.
    void update(const FrameScene& scene, const GpuScene& gpu_scene, const EmissiveTriangles& emissive,
                const RenderSettings& settings);

    // LightData: punctual lights in the order of FrameScene::lights, then area samples. Bind at
    // kLightsBinding.
    const gpu::Buffer& lights() const { return light_buffer_; }
    std::span<const LightData> light_data() const { return lights_; }     // what lights() holds
    int light_count() const { return static_cast<int>(lights_.size()); }  // punctual lights and area samples
    int punctual_count() const { return punctual_count_; }                // the first so many of lights()
    // The same lights as shading takes them, and LightData of those.
    const ShiningLights& shining() const { return shining_; }
    // LightData of shining(), to be bound in place of lights().
    const gpu::Buffer& shining_buffer() const { return shining_buffer_; }
    // ShiningLights::nodes.
    const gpu::Buffer& nodes_buffer() const { return nodes_buffer_; }
    // What area samples stand for, in ever smaller parts (near_emitters.h), for those of them whose
    // LightData::cone_offset is more than 0; without storage before there are any.
    const gpu::Buffer& emitter_nodes() const { return emitter_nodes_.buffer(); }
    // Whether there are more lamps than maps can be: groups of them use the map of one
    // (LightData::map_offset).
    bool shares_maps() const { return shares_maps_; }

    // Arrays of resolution() squared times the punctual lights' layers; layers as LightData says.
    // R32F: metres from the light (directional: from the map's near plane); 0 where nothing is seen.
    const gpu::Texture& distance() const { return punctual_.distance(); }
    // RG16_SNORM: octahedral geometric normal, facing the light.
    const gpu::Texture& normals() const { return punctual_.normals(); }
    // RGBA16F: what surfaces reflect of even light, as kept_albedo.glsl reads it: the materials are part of
    // it.
    const gpu::Texture& albedo() const { return punctual_.albedo(); }
    int resolution() const { return punctual_.resolution(); }  // texels a side

    // The area samples' cubes, area_resolution() squared; shadows alone.
    const gpu::Texture& area_distance() const { return area_.distance(); }
    const gpu::Texture& area_normals() const { return area_.normals(); }  // as normals()
    int area_resolution() const { return area_.resolution(); }            // texels a side

    int layers_drawn() const { return layers_drawn_; }  // by the last update, whole or movers alone
    std::size_t still_bytes() const { return punctual_.still_bytes() + area_.still_bytes(); }  // GPU memory
    std::uint64_t version() const { return version_; }  // grows whenever a light or map changes

  private:
    enum class Which { all, still, rested, moving };

    // The scene's lights with their places in maps of `resolution`, at most `most` layers.
    std::vector<LightData> describe_lights(const FrameScene& scene, int resolution, int most);
    void make_trees();  // of shining_
    void prepare(std::size_t index, const FrameScene& scene, const GpuScene& gpu_scene);
    // Those that the face sees, into the layer begun.
    void draw(const LightData& light, int face, const GpuScene& gpu_scene, Which which);
    SceneMotion::Seen seen(const LightData& light, int face) const;
    bool may_keep_another() const;
    // Clears the shadow map of a light that is off; it is redrawn when the light turns on.
    void leave_out(std::size_t index);
    // All faces of a light's map.
    void draw_anew(std::size_t index, const FrameScene& scene, const GpuScene& gpu_scene);
    // Whether anything changed that the light's map shows.
    bool sees_change(std::size_t index) const;
    // Those of `due` that are brightest where something changed and have waited longest; the others wait.
    void follow_most_urgent(std::vector<std::size_t>& due, const FrameScene& scene,
                            const GpuScene& gpu_scene);
    // Those faces that see what changed.
    void follow(std::size_t index, const FrameScene& scene, const GpuScene& gpu_scene);

    SceneProgram program_;
    SceneProgram area_program_;
    LightMapArray punctual_{true};
    LightMapArray area_{false};
    SceneMotion motion_;
    std::vector<LightData> lights_;
    std::vector<LightData> described_;  // the scene's, before they share maps
    std::vector<LightData> area_samples_;
    std::vector<std::array<bool, 6>> has_movers_;  // by light and face: what the map shows
    std::vector<int> steady_;                      // by light: updates that its map was right for
    std::vector<int> waits_;                       // by light: updates that its map is out of date for
    std::vector<bool> outdated_;                   // by light: left empty
    std::vector<DrawnInstance> visible_;
    gpu::GrowingBuffer emitter_nodes_;
    std::uint64_t emissive_version_ = ~0ull;
    RenderSettings settings_;
    gpu::Buffer light_buffer_;
    ShiningLights shining_;
    gpu::Buffer shining_buffer_;
    gpu::Buffer nodes_buffer_;
    bool shares_maps_ = false;
    float lamps_error_ = 0;  // that the trees were made for
    int punctual_count_ = 0;
    int layers_drawn_ = 0;
    std::uint64_t version_;
};

}  // namespace lanthorn::render
