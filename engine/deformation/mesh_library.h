// What deformation makes of each mesh once, kept for as long as the assets have the mesh.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lanthorn/deformation/bind_pose.h"
#include "lanthorn/deformation/subdivision_surface.h"
#include "lanthorn/scene/frame_scene.h"

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
    // Follows the assets; O(1) while their serial stays, else O(data of the meshes that deform). A mesh whose
    // data are as before is the same PreparedMesh as before.
    void follow(const std::shared_ptr<const SceneAssets>& assets);

    // Null for one that does not deform or exist. O(1).
    const std::shared_ptr<const PreparedMesh>& find(std::uint32_t mesh) const;

    // The mesh's triangles turned round, for joints that mirror. Made when first asked for.
    std::shared_ptr<const RefinedTopology> turned(std::uint32_t mesh);

  private:
    std::shared_ptr<const SceneAssets> assets_;
    std::vector<std::shared_ptr<const PreparedMesh>> meshes_;     // by index into the assets' meshes
    std::vector<std::shared_ptr<const RefinedTopology>> turned_;  // likewise
};

}  // namespace lanthorn::deform
