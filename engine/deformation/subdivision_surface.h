// A mesh's cage, and its surface at each level of refinement, built with OpenSubdiv when first asked for.
//
// Limit surfaces of Catmull and Clark (1978) and Loop (1987) with creases (DeRose et al. 1998). Boundaries
// are creases and their corners stay sharp; texture coordinates and colours are linear within faces. Where
// creases are still sharp at the level, each side has its own normal.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "engine/deformation/cage_topology.h"
#include "engine/deformation/limit_stencils.h"
#include "lanthorn/scene/deformed_mesh.h"

namespace lanthorn::deform {

// One level of refinement.
struct RefinedSurface {
    LimitStencils stencils;
    std::shared_ptr<const RefinedTopology> topology;  // one vertex a stencil
    std::shared_ptr<const RefinedTopology> turned;    // its triangles turned round, for joints that mirror
};

class SubdivisionSurface {
  public:
    static constexpr std::uint32_t kMostLevel = 5;
    // Triangles that no level goes beyond: finer ones are refused.
    static constexpr std::uint64_t kMostTriangles = 4'000'000;

    // Needs mesh.cage. Never throws for bad data: see problem().
    explicit SubdivisionSurface(const Mesh& mesh);
    ~SubdivisionSurface();

    // Why there is no surface; empty if there is one.
    const std::string& problem() const { return problem_; }
    // What of the cage was left out or lessened; empty if nothing.
    const std::string& remark() const { return remark_; }
    // The cage's own, or the finest of fewer than kMostTriangles.
    std::uint32_t finest() const { return finest_; }
    // Between neighbouring control points in the bind pose, the longest.
    float longest_edge() const { return longest_edge_; }
    const CageTopology& cage() const { return cage_; }

    // 1 .. finest(); only without a problem(). The first call for a level builds it: about 5 us a refined
    // vertex. Not for several threads at once.
    const RefinedSurface& at(std::uint32_t level);

  private:
    std::string problem_, remark_;
    std::uint32_t finest_ = 0;
    float longest_edge_ = 0;
    SubdivisionScheme scheme_;
    CageTopology cage_;
    std::vector<Vertex> vertices_;  // the mesh's
    std::array<std::unique_ptr<RefinedSurface>, kMostLevel + 1> levels_;
};

}  // namespace lanthorn::deform
