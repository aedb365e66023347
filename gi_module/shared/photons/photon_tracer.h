// Walks of light from its sources over surfaces, by Embree (Lavignotte and Paulin 2003, sec. 2.1).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "gi_module/reference/bsdf.h"
#include "gi_module/reference/tile_workers.h"
#include "gi_module/shared/photons/photon.h"
#include "gi_module/shared/photons/photon_sources.h"

namespace lanthorn::gi {

// What light does at surfaces that are neither mirrors nor glass. Mirrors (metal of roughness < 0.4) and
// glass follow the material's own BSDF, boundaries of volumes Fresnel, Snell and Beer, in both.
enum class PhotonScattering {
    even,  // Lambert of what the material reflects of even light (diffuse_reflectance.h), as `path` by
           // default
    full   // the material's own BSDF (bsdf.h), as `path` with path.transport=full; blended surfaces take part
};

struct PhotonSettings {
    int bounces = 2;  // reflections before the last surface, at most 255
    std::uint32_t seed = 1;
    PhotonScattering scattering = PhotonScattering::even;
};

class PhotonTracer {
  public:
    // Everything must outlive this. Thread-safe from here on.
    PhotonTracer(const reference::TraceScene& scene, const reference::MaterialTable& materials,
                 const PhotonSources& sources, const PhotonSettings& settings);

    // Walks first .. first + count - 1: every surface that each meets, until it is absorbed (Russian
    // roulette: a photon that goes on keeps the flux of its strongest channel), has been reflected `bounces`
    // times or leaves the scene. The same whatever the range and the number of threads. About 64 bytes a
    // photon.
    PhotonRun trace(std::uint64_t first, std::uint64_t count, reference::TileWorkers& workers) const;

    // The same for callers that want only a part of them at a time: `take(part, photons)` is called on the
    // worker threads, once for each kPart walks (fewer at the end), parts numbered from 0, and keeps what it
    // needs. The photons of the others are empty.
    static constexpr std::uint64_t kPart = 256;
    using Take = std::function<void(std::size_t part, std::span<const Photon> photons)>;
    PhotonRun trace(std::uint64_t first, std::uint64_t count, reference::TileWorkers& workers,
                    const Take& take) const;

  private:
    struct Flight;
    struct Batch;
    static const Flight kNew;
    enum class Next : std::uint8_t { ends, goes_on, leaves_diffusely, leaves_by_material };
    void begin(std::uint64_t first, int count, Batch& batch) const;
    void step(Batch& batch, PhotonRun& run) const;
    void finish(Batch& batch, std::vector<Photon>& photons) const;
    // At the surface that its ray has met. What a walk that leaves it has to know of it goes to lane `kept`.
    Next arrive(Batch& batch, int lane, int kept, reference::SurfaceHit& hit, PhotonRun& run) const;
    Next pass_boundary(Flight& flight, const reference::SurfaceHit& hit,
                       const reference::SurfaceMaterial& material, float survival, bool& opaque) const;
    Next turn(Batch& batch, int lane) const;
    bool survives(Flight& flight, const vec3& share, float choice) const;
    vec3 attenuation(std::uint32_t material, float metres) const;
    void store(Batch& batch, int lane, const reference::SurfaceHit& hit, bool diffuse, PhotonRun& run) const;

    const reference::TraceScene& scene_;
    const reference::MaterialTable& materials_;
    const PhotonSources& sources_;
    PhotonSettings settings_;
    reference::Blended blended_;
};

}  // namespace lanthorn::gi
