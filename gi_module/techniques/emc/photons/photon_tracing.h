// Photon tracing: emission from every light, then bounces through the environment maps (Yao et al. 2010, sec.
// 3, 5, 7).
#pragma once

#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "gi_module/techniques/emc/maps/map_rounds.h"
#include "gi_module/techniques/emc/photons/photon_set.h"
#include "gi_module/techniques/emc/photons/sky_photons.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/growing_buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class PhotonTracing {
  public:
    PhotonTracing();

    struct Share {
        bool sky = true;  // photons come from the sky, too
        int room = 0;     // that there is memory for, if not for more; it is taken again when that changes
        // uint by emissive triangle: its photons' arrivals at first surfaces are stored, too, after those of
        // all bounces. Not together with the sky's.
        const gpu::Buffer* first_of = nullptr;
    };
    // Emits settings.photons photons and traces `bounces` bounces. `total_area` is the scene's, in m^2. Each
    // `pass` (from 0) has photons of its own, that go on with the sequences of the one before.
    void trace(const render::LightInputs& inputs, const EnvironmentMaps& maps, const GiSettings& settings,
               int bounces, double total_area, int pass, const Share& share);

    // From the next trace() on arrived() says in which direction each photon has come, for glossy surfaces.
    void keep_directions(bool keep) { directions_wanted_ = keep; }

    // By bounce, from the first, then by photon: every place is taken. Under a sky as many follow, of its
    // photons at their first surfaces.
    const PhotonSet& arrived() const { return arrived_; }
    const gpu::Buffer& rays() const { return rays_; }  // PhotonRay[photon] after the last bounce
    // One uint32: NaNs and infinities replaced since construction, of photons and of pixels that gather them.
    const gpu::Buffer& bad_values() const { return bad_values_; }
    std::uint32_t bad_value_count() const;  // waits for the GPU

    // Reads all photons back: slow, for reports and tests.
    PhotonStatistics statistics() const;

  private:
    void build_programs(Search search, bool directions);
    int describe_sources(const render::LightInputs& inputs, const Aabb& surroundings, int photons, bool sky);

    gpu::Program emission_;
    gpu::Program emission_punctual_;
    gpu::Program emission_sky_, emission_first_;
    gpu::Program bounce_one_map_;
    gpu::Program bounce_;
    Search search_ = Search::march;
    bool directions_wanted_ = false;
    bool directions_kept_ = false;  // by the programs
    gpu::Buffer rays_;
    PhotonSet arrived_;
    gpu::GrowingBuffer sources_;
    gpu::BufferTexture sources_view_;
    gpu::Buffer bad_values_;
    MapRounds rounds_;
    gpu::Texture no_light_map_;
    SkyPhotons sky_;
    int room_ = 0;  // photons that there is memory for
    int photons_ = 0;
    int emitted_ = 0;  // of them, by the last trace(): all, or none where no lamp shines
    int bounces_ = 0;
    int rows_ = 0;  // bounces_, and one for arrivals at first surfaces
    bool first_are_skys_ = false;
    dvec3 flux_emitted_{0};
};

// Flux of a punctual light in lumen (rgb) that its photons carry. Directional: illuminance times the area of
// the disc of radius `extent` metres that photons start from. Spot: its smooth cone integrated numerically.
dvec3 emitted_flux(const Light& light, double extent);

// Lumen of surfaces, of those beyond `surroundings` (if they are not empty) about what arrives there.
// O(emissive triangles).
dvec3 flux_about(const render::EmissiveTriangles& emissive, const Aabb& surroundings);

}  // namespace lanthorn::gi
