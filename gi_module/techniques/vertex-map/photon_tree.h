// The k-d tree over the photons in use, which stage 2 of Jozwowski 2002 (sec. 4.1.2) balances in every frame,
// in two ways: built anew, or kept and mended where photons have come and gone. The second answers the
// thesis's first open problem (sec. 6, "Balancing the K-D Tree").
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "gi_module/techniques/vertex-map/photon_store.h"

namespace lanthorn::gi {

// A photon that a search has met.
struct NearPhoton {
    float distance2 = 0;      // square of the distance, m^2
    std::uint32_t place = 0;  // in the PhotonStore
};

// The photons of each surface have a tree of their own: what lies near by on others is not looked at.
enum class TreeSurfaces { apart, together };  // together: one tree for all, whatever surface is asked for

class PhotonTree {
  public:
    virtual ~PhotonTree() = default;
    // Takes in what the store says has changed since the last call; the caller forgets it then. `anew`: the
    // whole store, as the first time. The store must outlive the searches.
    virtual void update(const PhotonStore& store, bool anew) = 0;
    // All photons in use on `surface` within `radius` of `point`, in no order that means anything, appended
    // to `found`. Any number of threads may search at once.
    virtual void within(SurfaceKey surface, const vec3& point, float radius,
                        std::vector<NearPhoton>& found) const = 0;
    virtual std::size_t size() const = 0;  // photons in it
};

// Built anew in every update, by nanoflann (Blanco and Rai 2014). O(n log n).
std::unique_ptr<PhotonTree> make_rebuilt_tree(TreeSurfaces surfaces = TreeSurfaces::apart);

}  // namespace lanthorn::gi
