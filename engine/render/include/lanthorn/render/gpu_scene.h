// A FrameScene's meshes, materials, textures and instances on the GPU, and how they are drawn.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "lanthorn/core/frustum.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/growing_buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/render/scene_geometry.h"
#include "lanthorn/render/scene_program.h"
#include "lanthorn/render/scene_structs.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::render {

class SceneTextures;

// Which instances, by their material's alpha mode: all, those that may hide what is behind them (also parts
// of what is blended), or those that are blended.
enum class DrawSet { all, solid, blend };

// Which faces are left out: as the material says (back faces of single-sided ones), or none.
enum class Culling { by_material, none };

// How wide a map's texels are where something stands: `spread` metres a metre from `eye`, and `width` more.
struct TexelSize {
    vec3 eye{0};  // render space
    float spread = 0;
    float width = 0;
};

// An instance as finely as a map needs it.
struct DrawnInstance {
    std::uint32_t instance = 0;  // index into FrameScene::instances
    std::uint32_t level = 0;     // GpuScene::level()
    int layers = 1;
    std::uint32_t first_layer = 0;  // for the program: attribute 7, where `tagged`
    // Some of its triangles alone: of draw_tagged()'s own indices, 3 a triangle; 0: those of its level.
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
};

class GpuScene {
  public:
    // What stands or is shaped otherwise than before the last update, and was there then.
    struct Mover {
        std::uint32_t instance = 0;  // index into FrameScene::instances
        bool bent = false;           // its vertices differ as well (draw_before())
        mat4 before{1};              // its transform then
    };

    // Texels that a coarser shape may be off by.
    static constexpr float kTexelsOff = 0.75f;
    // Pixels of the picture that one may be off by, and that its edges may be long.
    static constexpr float kPixelsOff = 0.25f, kPixelsLong = 2;
    static constexpr std::uint32_t kTooSmall = 0xffffffffu;  // no level: too small to be seen

    GpuScene();
    ~GpuScene();
    GpuScene(const GpuScene&) = delete;
    GpuScene& operator=(const GpuScene&) = delete;

    // Uploads what differs from the last call: meshes, materials and images of other versions, instances that
    // were added, moved or deformed. On the CPU O(instances) when geometry changed, O(assets) more when
    // assets did, O(1) otherwise.
    void update(const FrameScene& scene);

    // Whether updates list movers(): O(instances) and a copy of bent vertices, when geometry changes.
    void keep_before(bool keep);
    // By the last update, in order of instances; none where nothing is kept.
    std::span<const Mover> movers() const { return movers_; }
    // As draw_tagged(), with attribute 8: where a vertex was before the last update, in the space that
    // Mover::before takes to render space. All of `instances` are bent, or none is.
    void draw_before(const gpu::Program& program, std::span<const DrawnInstance> instances, bool bent) const;

    // Bytes, by the last update.
    struct Uploaded {
        std::size_t geometry = 0;
        std::size_t images = 0;
        std::size_t materials = 0;
        std::size_t instances = 0;
    };
    const Uploaded& uploaded() const { return uploaded_; }  // nothing of it is kept for the next update

    // Draws every instance of `set` `layers` times (gl_InstanceID = 0..layers-1; the instance's index comes
    // from fetch_vertex() of scene_vertex.glsl) with `program`, which is put in use; material textures are
    // bound to units 0..7. Leaves culling disabled and the samplers of those units unbound. O(instances) draw
    // calls.
    void draw(const gpu::Program& program, DrawSet set, int layers = 1,
              Culling culling = Culling::by_material) const;
    // The same for the given instances (indices into FrameScene::instances), in the order given.
    void draw(const gpu::Program& program, std::span<const std::uint32_t> instances, int layers = 1,
              Culling culling = Culling::by_material) const;

    // The coarsest level of something that moves or deforms at which nothing is off by more than kTexelsOff
    // texels, as far as its box is; 0: all triangles. kTooSmall: its whole box is within that. O(levels).
    std::uint32_t level(std::uint32_t instance, const TexelSize& texel) const;
    // The same for the picture, where coarser triangles must shade as all of them do: only of what deforms
    // and has no texture, within kPixelsOff and kPixelsLong.
    std::uint32_t picture_level(std::uint32_t instance, const TexelSize& pixel) const;
    // Triangles that an instance has at a level.
    std::uint32_t triangle_count(std::uint32_t instance, std::uint32_t level) const {
        return range({instance, level}).index_count / 3;
    }
    std::uint32_t id(std::uint32_t instance) const { return instances_[instance].id; }  // Instance::id
    // Whether levels are made use of from here on; else level() is 0.
    void use_levels(bool use) { levels_used_ = use; }
    bool uses_levels() const { return levels_used_; }  // as use_levels() has been told

    // What is added to the levels of mipmaps that draws read from here on: negative where the picture will
    // have more pixels than are drawn.
    void set_texture_bias(float levels) const;

    // The same as draw(), at levels. Tagged: attribute 6 and 7 of scene_vertex.glsl are the instance and its
    // first layer, from a buffer of this call's.
    void draw(const SceneProgram& program, std::span<const DrawnInstance> instances,
              Culling culling = Culling::by_material) const;
    // With one program for all materials. `indices`: into the vertices of the mesh that each instance has;
    // if there are any, every one of `instances` says which are its own.
    void draw_tagged(const gpu::Program& program, std::span<const DrawnInstance> instances,
                     Culling culling = Culling::by_material,
                     std::span<const std::uint32_t> indices = {}) const;

    // The instances of a set, grouped by variant and material.
    std::span<const std::uint32_t> instances(DrawSet set) const;

    // Those of them whose bounds touch `frustum` (render space), in the same order, into `visible`.
    void find_visible(DrawSet set, const Frustum& frustum, std::vector<std::uint32_t>& visible) const;

    // By how near their boxes come to `eye` (render space), those as near in the order given: what near ones
    // hide is then not shaded. O(n log n).
    void sort_near_first(std::span<DrawnInstance> instances, const vec3& eye) const;

    // As the first draw(), with the variant that each material needs, prepare()d for variants(); the fewer
    // textures and holes, the faster.
    void draw(const SceneProgram& program, DrawSet set, int layers = 1,
              Culling culling = Culling::by_material) const;
    // The same for the given instances, in the order given.
    void draw(const SceneProgram& program, std::span<const std::uint32_t> instances, int layers = 1,
              Culling culling = Culling::by_material) const;

    // What the materials in use ask of shaders.
    std::span<const MaterialVariant> variants() const { return variants_; }

    // Binds the instance and material buffers (kInstancesBinding, kMaterialsBinding); draw() does it too.
    void bind() const;
    // The materials alone, at kKeptMaterialsBinding.
    void bind_materials() const { material_buffer_.bind_storage(kKeptMaterialsBinding); }

    std::uint64_t triangle_count() const { return triangles_; }  // over all instances
    float max_emissive() const { return max_emissive_; }         // nits: largest channel of any material used

  private:
    struct MaterialState {
        std::uint64_t version = 0;  // 0: nothing is in the slot
        bool double_sided = false;
        AlphaMode alpha = AlphaMode::opaque;
        bool solid_parts = true;  // what is blended may have some: alpha_coverage.h
        MaterialVariant variant = 0;
        float emissive = 0;  // nits, largest channel
    };
    static MaterialState state_of(const Material& material, std::uint64_t version);

    struct Placed {
        std::uint32_t id = 0, mesh = 0;
        mat4 transform{1};
    };

    // `drawn(k)`: the k-th; `program_of`: from MaterialVariant to const gpu::Program&.
    template <class DrawnOf, class ProgramOf>
    void draw_list(std::size_t count, bool tagged, Culling culling, const DrawnOf& drawn,
                   const ProgramOf& program_of) const;
    SceneGeometry::Range range(const DrawnInstance& drawn) const;
    // A texel where the instance is nearest, a share of its box's diagonal.
    float texel_share(std::uint32_t instance, const TexelSize& texel) const;
    void follow_assets(const SceneAssets& assets);
    void upload_materials(const AssetTable<Material>& materials);
    void upload_instances(const FrameScene& scene);
    void list_movers(const FrameScene& scene);
    void list_instances();

    std::uint64_t serial_ = 0;
    std::uint64_t last_frame_ = 0;
    SceneGeometry geometry_;
    std::vector<MaterialState> materials_;  // by slot
    std::vector<MaterialVariant> variants_;
    std::unique_ptr<SceneTextures> textures_;
    std::vector<InstanceData> instances_;
    std::vector<Aabb> bounds_;  // by instance
    bool keeps_before_ = false;
    std::vector<Placed> placed_;  // by instance, where they are kept
    std::vector<Mover> movers_;
    std::vector<bool> deforms_;            // by instance
    std::vector<std::uint32_t> lists_[3];  // by DrawSet
    gpu::Buffer material_buffer_;
    gpu::Buffer instance_buffer_;
    mutable gpu::GrowingBuffer tags_;  // of the last draw_tagged()
    mutable gpu::GrowingBuffer some_;  // its own indices
    gpu::Buffer instance_indices_;     // 0, 1, 2, ...: the integer attribute that baseInstance reads
    std::uint64_t triangles_ = 0;
    float max_emissive_ = 0;
    bool levels_used_ = true;
    Uploaded uploaded_;
};

}  // namespace lanthorn::render
