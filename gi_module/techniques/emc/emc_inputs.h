// What the passes of `emc` are made from, each with a version: settings, by what they alter; parts of the
// scene; light maps; and what the passes before make.
#pragma once

#include <cstdint>
#include <tuple>

#include "gi_module/shared/stamps.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/plan.h"

namespace lanthorn::gi {

enum class EmcInput : std::uint8_t {
    // Settings.
    map_settings,         // how many, of what, chosen among which
    round_settings,       // of the progressive update
    photon_settings,      // how photons are emitted, and meet maps
    lit_settings,         // lit maps, and what their rays meet
    lit_photon_settings,  // the photons that light them
    image_settings,       // splats or gather
    point_settings,       // what the gather's rays meet
    specular_settings,
    caustic_settings,
    size,  // of the picture
    // The scene.
    origin,    // of render space: remembered positions are relative to it
    sky_rays,  // whether rays light the texels with the sky's light alone, beside photons
    scene,     // as a whole
    geometry,
    pattern,
    paint,
    assets,
    relief,
    lights,
    emission,
    camera,
    darkness,       // frames without indirect light, and
    dark_surfaces,  // those of them in which surfaces changed, which nothing has followed
    light_maps,     // as drawn
    // EnvironmentMaps::Reach.
    reach,  // which centres the camera reaches
    bulk,   // much of what maps were chosen for has left it
    sight,  // maps that the camera sees are lost
    // What passes make, by the plan (EmcPlan::now).
    chosen_maps,      // EmcPass::selection
    drawn_maps,       // EmcPass::environment_maps
    exchanged_maps,   // EmcPass::progressive_update
    fade,             // from a map to the one in its place
    picture,          // EmcPass::splats, EmcPass::gather
    mean_picture,     // EmcPass::accumulation
    caustic_photons,  // and whether there are any
};
inline constexpr std::size_t kEmcInputs = static_cast<std::size_t>(EmcInput::caustic_photons) + 1;
using EmcStamps = Stamps<EmcInput, kEmcInputs>;

inline std::uint64_t& version_of(EmcStamps::Versions& versions, EmcInput input) {
    return versions[static_cast<std::size_t>(input)];
}

// Follows settings and scene from frame to frame.
class EmcInputs {
  public:
    // Brings their versions up to date in `versions`; leaves those of light maps, of EnvironmentMaps::Reach,
    // and of what passes make. `unlit`: of the scene.
    void follow(const FrameScene& scene, ivec2 size, const GiSettings& settings, Unlit unlit,
                EmcStamps::Versions& versions);

  private:
    using March = std::tuple<Search, int, bool, float>;
    Versioned<std::tuple<int, int, int, int, std::uint32_t, bool>> maps_;
    Versioned<int> round_;
    Versioned<std::tuple<int, bool, int, std::uint32_t, EmcFinal, Bandwidth, GlossyBandwidth, float, March>>
        photons_;
    Versioned<std::tuple<int, bool, std::uint32_t, EmcFinal, EmcRays, int, GatherSource, bool, March>> lit_;
    Versioned<int> lit_photons_;
    Versioned<std::tuple<std::uint64_t, EmcFinal, int, int, int, bool, SplatBase, float>> image_;
    std::uint64_t picture_ = 0;  // made again for other passes
    int passes_ = 0;
    Versioned<std::tuple<EmcFinal, int, int, int, bool>> points_;
    Versioned<std::tuple<float, int>> specular_;
    Versioned<std::tuple<int, std::uint32_t, int, float, bool>> caustics_;
    Versioned<ivec2> size_;
    Versioned<dvec3> origin_;
    Versioned<bool> sky_rays_;
    SceneVersions scene_;
    std::uint64_t darkness_ = 0;
    std::uint64_t dark_surfaces_ = 0;
};

}  // namespace lanthorn::gi
