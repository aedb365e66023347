// Whose turn it is: which photons are shot in a frame, and by which ways (stage 1 of Jozwowski 2002, sec.
// 4.1.1).
#pragma once

#include <cstdint>

#include "gi_module/shared/photons/photon_tracer.h"
#include "gi_module/techniques/vertex-map/photon_store.h"
#include "gi_module/techniques/vertex-map/vertex_map_settings.h"

namespace lanthorn::gi {

// A walk is a way through the scene, by its number (PhotonTracer::trace).
class PhotonTurns {
  public:
    // From here on all of `total` photons have to be shot; the first ones again with the first walks.
    void begin_again();
    // Something has changed: all that are kept are old.
    void outdate() { left_ = kAll; }
    // Photons that are to be shot until none is old.
    std::uint64_t left(const VertexMapSettings& settings) const;

    struct Shot {
        std::uint64_t photons = 0;  // shot
        std::uint64_t rays = 0;
        std::uint64_t bad = 0;  // whose flux was no number
    };
    // Shoots the next `count` photons, at most those that are left, into the places of the oldest. Hits are
    // of indirect light, and with settings.direct of all, as in the thesis. Each carries the flux of its
    // lights over the photons that are kept of them. The first one's levels are levels of the store. O(count
    // max_level log triangles).
    Shot shoot(const PhotonTracer& tracer, const PhotonSources& sources, const FrameScene& scene,
               std::uint64_t count, const VertexMapSettings& settings, PhotonStore& store,
               reference::TileWorkers& workers);

  private:
    static constexpr std::uint64_t kAll = ~std::uint64_t{0};

    std::uint64_t left_ = kAll;
    std::uint64_t next_ = 0;  // the oldest photon, which goes first
    std::uint64_t shot_ = 0;  // since begin_again()
};

}  // namespace lanthorn::gi
