// The photons of a scene, more and more of them while nothing changes.
#pragma once

#include <array>
#include <vector>

#include "gi_module/shared/photons/photon_scene.h"
#include "gi_module/techniques/splat/splat_store.h"

namespace lanthorn::gi {

class PhotonCollection {
  public:
    // What is traced at once takes up to so many bytes beside the store's.
    static constexpr std::uint64_t kMostAtOnce = 131'072;  // walks
    static constexpr std::size_t kTracing = 20u << 20;

    SplatStore& store() { return store_; }
    const SplatStore& store() const { return store_; }
    void clear();
    // `count` more walks, indirect light alone. Those that the disk takes no more are not counted, and there
    // is no end of it: false, and store().error() says why.
    bool grow(const PhotonScene& scene, const SplatSurfaces& surfaces, const PhotonSettings& settings,
              std::uint64_t count, reference::TileWorkers& workers);

    std::uint64_t walks() const { return walks_; }
    std::uint64_t rays() const { return rays_; }  // ever since clear()
    std::uint64_t bad() const { return bad_; }    // photons left out so far
    // By SurfaceSide; each once, however many records it takes.
    std::span<const std::uint64_t> photons(bool caustic) const { return photons_[caustic ? 1 : 0]; }
    std::uint64_t all(bool caustic) const { return all_[caustic ? 1 : 0]; }
    // By group: what a copy carries, lumen.
    std::vector<vec3> powers(const PhotonSources& sources) const;

  private:
    bool grow_once(const PhotonScene& scene, const SplatSurfaces& surfaces, const PhotonSettings& settings,
                   std::uint64_t count, reference::TileWorkers& workers);

    SplatStore store_;
    std::uint64_t walks_ = 0, rays_ = 0, bad_ = 0;
    std::array<std::vector<std::uint64_t>, 2> photons_;
    std::array<std::uint64_t, 2> all_{};
};

}  // namespace lanthorn::gi
