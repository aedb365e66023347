// Lit maps: what the surfaces that the environment maps show reflect, B = albedo (E0 + E1). E0 is direct
// irradiance, by the light maps; E1 is indirect irradiance, gathered from the lit maps themselves at a
// coarser resolution.
#pragma once

#include "lanthorn/gi/emc/lit_texels.h"
#include "lanthorn/gi/emc/remembered_hits.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/render/light_programs.h"

namespace lanthorn::gi {

class LitMaps {
  public:
    struct Work {
        bool forget = false;   // other maps: nothing that is remembered holds
        bool list = false;     // the maps show other surfaces or colours: texels are listed anew
        bool verify = false;   // things have moved, or a map was exchanged: what rays met is verified
        bool light = false;    // light, or what surfaces reflect, has changed: E0 anew
        bool compare = false;  // rays through the maps and exact ones are timed, and the faster shot
        bool shoot = false;    // a frame more of rays for E1
    };
    // Brings B up to date. It holds the light that has left the texels after 1 to `bounces` reflections,
    // exactly: for E1 the rays' hits are shaded bounces - 1 times, each time from the B before. If the
    // settings want endless bounces, each frame adds one to those that B holds from the frame before.
    // `bad_values` counts what is not finite.
    void update(const render::LightInputs& inputs, const EnvironmentMaps& maps, const SweptBoxes& movers,
                ExactRays* exact, const GiSettings& settings, int bounces, Work work,
                const gpu::Buffer& bad_values);

    const LitTexels& texels() const { return texels_; }
    // B, vec4 by place in the maps, lux; a < 0: no texel is lit there.
    const gpu::Buffer& radiosity() const { return bounces_ < 2 ? first_ : radiosity_; }
    int frames() const { return frames_; }  // of rays for E1, since surfaces changed
    // Of a first frame's rays for E1, when both ways were compared last; 0: never. Milliseconds.
    struct RayTimes {
        double maps = 0;
        double exact = 0;
    };
    const RayTimes& times() const { return times_; }
    // Rays of the last frame that shot any; waits for the GPU.
    std::uint64_t rays() const { return hits_.shot(); }
    std::size_t bytes() const;

  private:
    void build_programs();
    void list(const EnvironmentMaps& maps, const GiSettings& settings, const FrameScene& scene);
    void list_coarse();
    double time_of(const RayScene& rays);
    void light(const render::LightInputs& inputs, const gpu::Buffer& bad_values);
    void reflect(const render::LightInputs& inputs, const EnvironmentMaps& maps, const GiSettings& settings,
                 const gpu::Buffer& irradiance, float most_albedo);
    void bind_coarse(const gpu::Program& program, const gpu::Buffer& irradiance);

    LitTexels texels_;
    gpu::Buffer direct_;     // E0, vec4 by lit texel, lux
    gpu::Buffer first_;      // albedo E0, by place
    gpu::Buffer radiosity_;  // albedo (E0 + E1), by place
    int bounces_ = 1;
    SurfacePoints coarse_;  // where E1 is gathered
    gpu::Buffer coarse_index_;
    int coarse_resolution_ = 0;
    RememberedHits hits_{RememberedHits::Of::lit_maps};
    int frames_ = 0;
    bool radiosity_holds_ = false;  // light of the frame before
    RayTimes times_;
    gpu::Buffer filtered_[2];  // E1
    gpu::Program coarse_program_, filter_program_, reflect_program_;
    render::LightPrograms direct_programs_{{"gi_module/emc/lit_direct.comp"}};
    gpu::BufferTexture index_view_, points_view_, irradiance_view_;
};

}  // namespace lanthorn::gi
