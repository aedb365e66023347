// From OpenSubdiv's refined topology to stencils and triangles. For subdivision_surface.cpp alone:
// OpenSubdiv's headers stay out of the interface.
#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <vector>

#include "engine/deformation/subdivision_surface.h"

namespace lanthorn::deform {

// `refiner` is refined uniformly with full topology in its last level; its face-varying channel has the
// mesh's vertices. O(refined vertices).
RefinedSurface build_surface(const OpenSubdiv::Far::TopologyRefiner& refiner, const CageTopology& cage,
                             const std::vector<Vertex>& vertices);

}  // namespace lanthorn::deform
