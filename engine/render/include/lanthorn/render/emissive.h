// The emissive triangles of a scene: what photons leave from and what area lights are made of.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "lanthorn/gpu/growing_buffer.h"
#include "lanthorn/render/emissive_data.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn {
class KeptEmissivePieces;
}

namespace lanthorn::render {

// Keeps the list and what shaders read of it up to date from frame to frame.
class EmissiveTriangles {
  public:
    // Rebuilds the list if an emissive instance appeared, left, moved or changed, or what its material emits
    // did. What glows by a texture, or as far as alpha covers it, is cut into pieces that glow evenly (at
    // most 16 384 a mesh); what subdivision made has the mean. A blended one has emission times alpha.
    // Triangles without area or light are left out. O(emissive triangles) then.
    void update(const FrameScene& scene);

    // In order of instance. Bind with buffer().bind_storage(kEmissiveBinding).
    const gpu::Buffer& buffer() const { return buffer_.buffer(); }
    std::span<const EmissiveTriangleData> triangles() const { return triangles_; }  // what buffer() holds
    // The same triangles as the mesh has them before anything moves, turns or bends it (what subdivision
    // made: as bent): bit for bit the same in every frame.
    struct Rest {
        vec3 p[3];
    };
    std::span<const Rest> at_rest() const { return at_rest_; }         // one a triangle, in their order
    int count() const { return static_cast<int>(triangles_.size()); }  // of triangles
    vec3 flux() const { return flux_; }  // lumen, rgb: pi * radiance * area, twice for double-sided ones
    std::uint64_t version() const { return version_; }  // grows with every rebuild

    // One instance's run of triangles.
    struct Surface {
        std::uint32_t instance_id = 0;
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        vec3 flux{0};  // lumen
    };
    std::span<const Surface> surfaces() const { return surfaces_; }  // in order of instance

  private:
    struct Source {
        std::uint32_t id = 0;
        std::uint32_t mesh = 0;
        std::uint64_t version = 0;       // Instance::version
        std::uint64_t mesh_version = 0;  // of the asset
        std::uint64_t emission = 0;      // AssetVersion<Material>
        std::uint64_t surface = 0;       // likewise
        mat4 transform{1};
        bool operator==(const Source&) const = default;
    };
    void build(const FrameScene& scene);

    std::uint64_t serial_ = 0;
    std::uint64_t last_frame_ = 0;
    std::uint64_t version_ = 0;
    std::shared_ptr<KeptEmissivePieces> pieces_;  // null before the first build()
    std::vector<Source> sources_;
    std::vector<Surface> surfaces_;
    std::vector<EmissiveTriangleData> triangles_;
    std::vector<Rest> at_rest_;
    gpu::GrowingBuffer buffer_;
    vec3 flux_{0};
};

}  // namespace lanthorn::render
