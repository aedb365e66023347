// The vertices and triangles of a FrameScene on the GPU: the assets' once, those of deformed instances anew
// whenever they change.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <vector>

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/scene/frame_scene.h"

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

    // Uploads what differs from the last call: everything when assets change or instances are deformed that
    // were not, or have another topology; else 40 bytes a vertex of each DeformedMesh whose version is
    // another.
    void update(const FrameScene& scene);

    // Of FrameScene::instances[instance] in the last update.
    const Range& range(std::size_t instance) const { return ranges_[instance]; }
    // Attributes 0..5 as scene_vertex.glsl names them. Changes only when everything was uploaded.
    GLuint vertex_array() const { return vertex_array_; }

  private:
    struct Deformed {
        std::uint32_t id = 0;
        std::uint32_t mesh = 0;
        std::uint64_t topology = 0;  // RefinedTopology::serial, 0: the mesh's own
        std::size_t vertex_count = 0;
        std::uint64_t version = 0;
        Range range;

        bool same_topology(const Deformed& o) const {
            return id == o.id && mesh == o.mesh && topology == o.topology && vertex_count == o.vertex_count;
        }
    };

    static std::vector<Deformed> list_deformed(const FrameScene& scene);
    void upload_all(const FrameScene& scene);
    void make_vertex_array();

    std::uint64_t serial_ = ~0ull;
    std::vector<Range> meshes_;
    std::vector<Deformed> deformed_;  // in order of instances
    std::vector<Range> ranges_;
    gpu::Buffer frames_;     // VertexFrame: what deformation moves
    gpu::Buffer constants_;  // texture coordinates and colour
    gpu::Buffer indices_;
    GLuint vertex_array_ = 0;
};

}  // namespace lanthorn::render
