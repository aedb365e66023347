// What deformation makes of each mesh once, kept for as long as the assets have the mesh.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/deformation/bind_pose.h"
#include "engine/deformation/subdivision_surface.h"
#include "lanthorn/scene/deformed_mesh.h"
#include "lanthorn/scene/scene_assets.h"

namespace lanthorn::deform {

struct PreparedMesh {
    std::array<std::uint64_t, 2> key;  // of all that follows: equal for equal meshes
    std::string name;
    BindPose pose;
    Aabb bounds;                                  // of the bind pose
    std::shared_ptr<SubdivisionSurface> surface;  // null: no cage
};

class MeshLibrary {
  public:
    // Follows the assets; O(1) while their serial stays, else O(meshes), and O(data) of those that deform and
    // are new or altered. A mesh whose data are those of another is the same PreparedMesh.
    void follow(const SceneAssets& assets);

    // Null for one that does not deform or exist. O(1).
    const std::shared_ptr<const PreparedMesh>& find(MeshHandle mesh) const;

    // The mesh's triangles turned round, for joints that mirror. Made when first asked for.
    std::shared_ptr<const RefinedTopology> turned(std::uint32_t slot);
    // Meshes whose data were looked at, in all.
    std::size_t looked_at() const { return looked_at_; }

  private:
    struct Entry {
        std::uint64_t version = 0;
        std::uint32_t generation = 0;
        std::shared_ptr<const Mesh> mesh;              // null: it does not deform
        std::shared_ptr<const PreparedMesh> prepared;  // likewise
        std::shared_ptr<const RefinedTopology> turned;
    };

    std::uint64_t serial_ = 0;
    std::size_t looked_at_ = 0;
    std::vector<Entry> entries_;  // by slot of the assets' meshes
};

}  // namespace lanthorn::deform
