// The vertices and triangles of a FrameScene on the GPU: those of meshes once, those of deformed instances
// again whenever they change.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "lanthorn/core/range_allocator.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/scene/frame_scene.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::render {

class SceneGeometry {
  public:
    // What glDrawElements* takes.
    struct Range {
        std::uint32_t first_index = 0;
        std::uint32_t index_count = 0;
        std::int32_t base_vertex = 0;
    };

    // Coarser triangles over the same vertices.
    struct Level {
        std::uint32_t first_index = 0;
        std::uint32_t index_count = 0;
        float error = 0;  // how far they lie from the full ones, a share of the diagonal of the shape's box
        float edge = 0;   // their mean edge, the same share
    };

    SceneGeometry() = default;
    ~SceneGeometry();
    SceneGeometry(const SceneGeometry&) = delete;
    SceneGeometry& operator=(const SceneGeometry&) = delete;

    // Uploads what differs from the last call: meshes that are new or of another version, deformed instances
    // that were not there or have another topology, and of the others 40 bytes a vertex where
    // DeformedMesh::version is another. What is gone leaves its place to what comes. Buffers that are too
    // small grow, by a copy on the GPU. What has the same triangles has them once. O(meshes + instances) on
    // the CPU when assets change, else O(instances). The first time that a shape deforms or moves: its
    // coarser levels, about 2 us a triangle.
    void update(const FrameScene& scene);
    // Of vertices and indices, by the last update.
    std::size_t uploaded_bytes() const { return uploaded_bytes_; }

    // Whether the next updates keep what vertices were before, for bent(): 40 bytes a vertex.
    void keep_before(bool keep) { keeps_before_ = keep; }
    // The last update wrote other vertices for it, of the same triangles.
    bool bent(std::size_t instance) const { return bent_[instance]; }
    // Attribute 8 is the position before the last update, of what is bent, or the same as attribute 0.
    void bind_before(bool bent) const;
    void unbind_before() const;  // attribute 8 is off again

    // Of FrameScene::instances[instance] in the last update.
    const Range& range(std::size_t instance) const { return ranges_[instance]; }
    // The same one's, finer ones first; only of what deforms, or has the mesh of something that has moved.
    std::span<const Level> levels(std::size_t instance) const { return *levels_[instance]; }
    // Attributes 0..5 as scene_vertex.glsl names them. Another one after a buffer has grown.
    GLuint vertex_array() const { return vertex_array_; }
    const gpu::Buffer& indices() const { return indices_; }  // its element buffer

  private:
    // Where vertices lie in the buffers.
    struct Block {
        std::size_t first = 0, count = 0;
    };
    // Triangles, and coarser ones behind them.
    struct IndexList {
        std::size_t first = 0, count = 0;  // with all levels; a count of 0: nothing is there
        std::size_t own = 0;               // of the count: the full triangles
        std::vector<Level> levels;
        bool has_levels = false, used = false;
    };
    // RefinedTopology::serial, 0: the mesh's own triangles, of the slot and version that follow.
    using Topology = std::tuple<std::uint64_t, std::uint32_t, std::uint64_t>;
    struct Kept {
        std::uint64_t version = 0;  // of the mesh; 0: nothing is there
        Block block;
        IndexList* triangles = nullptr;
    };
    struct Deformed {
        std::uint32_t id = 0;
        std::uint32_t mesh = 0;
        std::uint64_t mesh_version = 0;
        std::uint64_t topology = 0;  // RefinedTopology::serial, 0: the mesh's own
        std::size_t vertex_count = 0;
        std::uint64_t version = 0;  // of the vertices; 0: nothing is there
        Block block;
        IndexList* triangles = nullptr;

        bool same_topology(const Deformed& o) const {
            return id == o.id && mesh == o.mesh && mesh_version == o.mesh_version && topology == o.topology &&
                   vertex_count == o.vertex_count;
        }
    };
    // A list that is to be written.
    struct Wanted {
        IndexList* list;
        std::vector<std::uint32_t> indices;
    };

    static std::vector<Deformed> list_deformed(const FrameScene& scene);
    void drop_meshes(const SceneAssets& assets);
    void follow_deformed(const FrameScene& scene);
    void follow_movers(const FrameScene& scene);
    // The lists that meshes and deformed instances have in this frame; new ones are reported.
    std::vector<Wanted> follow_triangles(const FrameScene& scene);
    IndexList* list_for(const FrameScene& scene, const InstanceShape& shape, const Topology& topology,
                        bool coarsened, std::vector<Wanted>& wanted);
    void reserve(std::size_t vertices, std::size_t indices);
    void grow(std::size_t vertices, std::size_t indices);
    Block take_vertices(std::size_t count);
    std::size_t take_indices(std::size_t count);
    void give_back(const Block& block) { vertices_.give_back(block.first, block.count); }
    void upload(const Block& block, const InstanceShape& shape);
    void make_vertex_array();

    std::uint64_t serial_ = 0;
    std::vector<Kept> meshes_;        // by slot
    std::vector<bool> moved_;         // by slot: something that has the mesh has moved
    std::vector<Deformed> deformed_;  // in order of instances
    std::map<Topology, IndexList> triangles_;
    std::vector<Range> ranges_;
    std::vector<const std::vector<Level>*> levels_;
    RangeAllocator vertices_, index_places_;
    std::size_t uploaded_bytes_ = 0;
    bool keeps_before_ = false;
    std::vector<bool> bent_;
    gpu::Buffer frames_;     // VertexFrame: what deformation moves
    gpu::Buffer before_;     // the same of what is bent, as it was
    gpu::Buffer constants_;  // texture coordinates and colour
    gpu::Buffer indices_;
    GLuint vertex_array_ = 0;
};

}  // namespace lanthorn::render
