// The vertices and triangles of a FrameScene on the GPU: those of meshes once, those of deformed instances
// anew whenever they change.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <vector>

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/render/range_allocator.h"
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

    SceneGeometry() = default;
    ~SceneGeometry();
    SceneGeometry(const SceneGeometry&) = delete;
    SceneGeometry& operator=(const SceneGeometry&) = delete;

    // Uploads what differs from the last call: meshes that are new or of another version, deformed instances
    // that were not there or have another topology, and of the others 40 bytes a vertex where
    // DeformedMesh::version is another. What is gone leaves its place to what comes. Buffers that are too
    // small grow, by a copy on the GPU. O(meshes + instances) on the CPU when assets change, else
    // O(instances).
    void update(const FrameScene& scene);
    // Of vertices and indices, by the last update.
    std::size_t uploaded_bytes() const { return uploaded_bytes_; }

    // Of FrameScene::instances[instance] in the last update.
    const Range& range(std::size_t instance) const { return ranges_[instance]; }
    // Attributes 0..5 as scene_vertex.glsl names them. Another one after a buffer has grown.
    GLuint vertex_array() const { return vertex_array_; }

  private:
    // Where something lies in the buffers.
    struct Block {
        std::size_t first_vertex = 0, vertices = 0;
        std::size_t first_index = 0, indices = 0;

        Range range() const {
            return {static_cast<std::uint32_t>(first_index), static_cast<std::uint32_t>(indices),
                    static_cast<std::int32_t>(first_vertex)};
        }
    };
    struct Kept {
        std::uint64_t version = 0;  // of the mesh; 0: nothing is there
        Block block;
    };
    struct Deformed {
        std::uint32_t id = 0;
        std::uint32_t mesh = 0;
        std::uint64_t mesh_version = 0;
        std::uint64_t topology = 0;  // RefinedTopology::serial, 0: the mesh's own
        std::size_t vertex_count = 0;
        std::uint64_t version = 0;  // of the vertices; 0: nothing is there
        Block block;

        bool same_topology(const Deformed& o) const {
            return id == o.id && mesh == o.mesh && mesh_version == o.mesh_version && topology == o.topology &&
                   vertex_count == o.vertex_count;
        }
    };

    static std::vector<Deformed> list_deformed(const FrameScene& scene);
    void drop_meshes(const SceneAssets& assets);
    void follow_deformed(const FrameScene& scene);
    void reserve(std::size_t vertices, std::size_t indices);
    void grow(std::size_t vertices, std::size_t indices);
    Block take(std::size_t vertices, std::size_t indices);
    void give_back(const Block& block);
    void upload(const Block& block, const InstanceShape& shape);
    void make_vertex_array();

    std::uint64_t serial_ = 0;
    std::vector<Kept> meshes_;        // by slot
    std::vector<Deformed> deformed_;  // in order of instances
    std::vector<Range> ranges_;
    RangeAllocator vertices_, index_places_;
    std::size_t uploaded_bytes_ = 0;
    gpu::Buffer frames_;     // VertexFrame: what deformation moves
    gpu::Buffer constants_;  // texture coordinates and colour
    gpu::Buffer indices_;
    GLuint vertex_array_ = 0;
};

}  // namespace lanthorn::render
