// Lit maps: what the surfaces that the environment maps show reflect, B = albedo (E0 + E1). E0 is direct
// irradiance, by the light maps; E1 is indirect irradiance at a coarser resolution, gathered from the lit
// maps themselves, or by photons (lit_photons.h).
#pragma once

#include <memory>

#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "gi_module/techniques/emc/lit_maps/lit_photons.h"
#include "gi_module/techniques/emc/lit_maps/lit_texels.h"
#include "gi_module/techniques/emc/lit_maps/lit_work.h"
#include "gi_module/techniques/emc/lit_maps/wide_emitters.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/render/light_programs.h"

namespace lanthorn::gi {

class LitMaps {
  public:
    // What rays from the texels of a map's slot have met; none if there are none yet.
    KeptRays kept_rays(int slot) const;
    // Of maps that have come back: rays that the next update() goes on with.
    struct Returned {
        int slot = 0;
        std::shared_ptr<const KeptRays> rays;
    };
    // What is known once the maps are up to date.
    struct Found {
        bool other_maps = false;  // some have taken the place of others: all texels look again
        ivec2 exchanged{-1};      // unless it is one alone: of its slot, and that of the map that left
        bool compare = false;     // rays through the maps and exact ones are timed, and the faster shot
        std::vector<Returned> returned;
    };
    // Brings B up to date. It holds the light that has left the texels after 1 to `bounces` reflections,
    // exactly: for E1 the rays' hits are shaded bounces - 1 times, each time from the B before. If the
    // settings want endless bounces, each frame adds one to those that B holds from the frame before. Photons
    // have been reflected 1 to `photon_bounces` times themselves: what they bring is reflected once more, and
    // nothing is fed back. Under a sky rays then bring its light alone, and B is the sum. `bad_values` counts
    // what is not finite.
    void update(const render::LightInputs& inputs, const EnvironmentMaps& maps, const SweptBoxes& movers,
                ExactRays* exact, const GiSettings& settings, int bounces, const LitWork& work,
                const Found& found, const gpu::Buffer& bad_values);

    const LitTexels& texels() const { return texels_; }
    std::uint32_t lit_texels() const { return lists_.lit_count(); }  // waits for the GPU
    // B, vec4 by place in the maps, lux; a < 0: no texel is lit there. After them what the sky sends, by its
    // places.
    const gpu::Buffer& radiosity() const { return has_indirect_ ? radiosity_ : first_; }
    // E0 of all lights, as the picture has it; vec4 by place in the maps, lux.
    const gpu::Buffer& direct() const { return wide_.sampled() ? whole_direct_ : direct_; }
    // By place, a: a lit texel's width over its distance from the nearest lamp that has a place.
    const gpu::Buffer& nearness() const { return first_; }
    // What close hits reflect, into radiosity() behind the places of the sky. Cost: a look at each light's
    // map a hit.
    void light_close(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                     const GiSettings& settings, const CloseHits& close, const gpu::Buffer& bad_values);
    int frames() const { return frames_; }  // of rays for E1, since surfaces changed
    const LitPhotons& photons() const { return photons_; }
    // Of a first frame's rays for E1, when both ways were compared last; 0: never. Milliseconds, of processor
    // time where that is what draws: others at work on the machine then hardly tell.
    struct RayTimes {
        double maps = 0;
        double exact = 0;

        // Exact rays err less (docs/measurements.md), and what is chosen should be the same in the next run.
        bool prefer_maps() const { return 2 * maps <= exact; }
    };
    const RayTimes& times() const { return times_; }
    // Rays of the last frame that shot any; waits for the GPU.
    std::uint64_t rays() const { return hits_.shot(); }
    std::size_t bytes() const;

  private:
    void build_programs();
    // Whether it is another than before. `apart`: its light is kept apart from the lamps'.
    bool follow_sky(const FrameScene& scene, bool apart);
    // Whether all texels did.
    bool look(const EnvironmentMaps& maps, const GiSettings& settings, const FrameScene& scene,
              const SweptBoxes& movers, bool all, const ivec2& exchanged);
    double time_of(const RayScene& rays);
    void light(const render::LightInputs& inputs, const EnvironmentMaps& maps, const GiSettings& settings,
               const SweptBoxes& movers, bool all, bool looked, const gpu::Buffer& bad_values);
    void shade(const render::LightInputs& inputs, const EnvironmentMaps& maps, const GiSettings& settings,
               const EntryList& relit, bool without_wide, bool looked, const gpu::Buffer& direct,
               const gpu::Buffer& bad_values);
    // Which texels light() has to do.
    const EntryList& list_relit(const render::LightInputs& inputs, const SweptBoxes& movers, bool all);
    const gpu::Buffer& smooth(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                              const GiSettings& settings, const gpu::Buffer& irradiance);
    void reflect(const render::LightInputs& inputs, const EnvironmentMaps& maps, const GiSettings& settings,
                 const gpu::Buffer& irradiance, float most_albedo, const gpu::Buffer& direct,
                 const gpu::Buffer& reflected);
    void add_sky(bool lamps);
    void carry_close();
    void bind_coarse(const gpu::Program& program, const gpu::Buffer& irradiance);

    LitTexels texels_;
    // By place in the maps, vec4, lux.
    gpu::Buffer direct_;                 // E0, but for the light of wide emitters that photons bring
    gpu::Buffer whole_direct_;           // that of their samples, too, if there are any
    gpu::Buffer first_;                  // albedo E0; a < 0: no texel is lit there
    gpu::Buffer radiosity_;              // albedo (E0 + E1)
    gpu::Buffer sky_alone_;              // 0 but for the sky
    gpu::Buffer from_sky_;               // albedo E1 of the sky's light alone, where photons bring the lamps'
    gpu::Buffer dark_;                   // 0
    std::optional<SkyInstance> of_sky_;  // that they hold
    bool sky_holds_ = false;
    LitLists lists_;                         // of lit texels, and of points where E1 is gathered
    EntryList relit_;                        // those whose E0 is due, unless it is all
    EntryList near_;                         // of these, those beside lamps
    EntryList rims_;                         // those without a texel of E1 beside them
    std::vector<render::LightData> lights_;  // that E0 comes from
    bool has_indirect_ = false;              // E1 is not 0
    RememberedHits hits_{RememberedHits::Of::lit_maps};
    LitPhotons photons_;
    bool photons_follow_ = false;  // the last look at the maps
    WideEmitters wide_;
    int frames_ = 0;
    bool radiosity_holds_ = false;  // light of the frame before, by rays
    RayTimes times_;
    gpu::Buffer filtered_;  // E1, smoothed
    gpu::Program filter_program_, reflect_program_, rims_program_, add_sky_;
    MoverPrograms relit_programs_{{"gi_module/techniques/emc/lit_maps/lit_relight.comp"}, {}};
    gpu::Buffer light_origins_;
    render::LightPrograms direct_programs_{{"gi_module/techniques/emc/lit_maps/lit_direct.comp"}};
    render::LightPrograms near_programs_{{"gi_module/techniques/emc/lit_maps/lit_direct_near.comp"}};
    render::LightPrograms close_programs_{{"gi_module/techniques/emc/lit_maps/lit_close.comp"}};
    gpu::BufferTexture close_points_view_, close_owners_view_;
    gpu::BufferTexture index_view_, points_view_, irradiance_view_, lit_points_view_, albedo_view_,
        direct_view_, changed_view_, light_origins_view_, fits_view_;
};

}  // namespace lanthorn::gi
