// What the passes of `emc` are made from beside what SceneChanges tells: settings, by what they alter, each
// with a version.
#pragma once

#include <cstdint>
#include <tuple>

#include "gi_module/shared/stamps.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_settings.h"

namespace lanthorn::gi {

enum class EmcInput : std::uint8_t {
    map_settings,         // how many, of what, chosen among which
    round_settings,       // of the progressive update
    photon_settings,      // how photons are emitted, and meet maps
    lit_settings,         // lit maps, and what their rays meet
    lit_photon_settings,  // the photons that light them
    image_settings,       // splats or gather
    point_settings,       // what the gather's rays meet
    specular_settings,
    caustic_settings,
    size,     // of the picture
    origin,   // of render space: what is remembered in it lies elsewhere now
    sky_rays  // texels that rays light know nothing of photons: a sky's light comes by rays
};
inline constexpr std::size_t kEmcInputs = 12;
using EmcStamps = Stamps<EmcInput, kEmcInputs>;

// What each of the things that `emc` keeps is made from.
struct EmcMade {
    EmcStamps maps{EmcInput::map_settings};
    EmcStamps round{EmcInput::round_settings};
    EmcStamps photons{EmcInput::photon_settings};
    EmcStamps lit{EmcInput::lit_settings, EmcInput::origin, EmcInput::sky_rays};
    EmcStamps lit_photons{EmcInput::lit_photon_settings};
    EmcStamps image{EmcInput::image_settings, EmcInput::size};
    EmcStamps specular{EmcInput::specular_settings, EmcInput::map_settings};
    EmcStamps caustics{EmcInput::caustic_settings, EmcInput::origin};
    EmcStamps caustic_image{EmcInput::image_settings, EmcInput::size};
};

class EmcInputs {
  public:
    // Those of a frame.
    EmcStamps::Versions follow(const FrameScene& scene, ivec2 size, const GiSettings& settings);

  private:
    using March = std::tuple<Search, int, bool, float>;
    Versioned<std::tuple<int, int, int, int, std::uint32_t>> maps_;
    Versioned<int> round_;
    Versioned<std::tuple<int, int, std::uint32_t, EmcFinal, Bandwidth, float, March>> photons_;
    Versioned<std::tuple<int, std::uint32_t, EmcFinal, EmcRays, int, GatherSource, bool, March>> lit_;
    Versioned<int> lit_photons_;
    Versioned<std::tuple<int, EmcFinal, int, int, int, bool, SplatBase, float>> image_;
    Versioned<std::tuple<EmcFinal, int, int, int, bool>> points_;
    Versioned<std::tuple<float, int>> specular_;
    Versioned<std::tuple<int, std::uint32_t, int, float>> caustics_;
    Versioned<ivec2> size_;
    Versioned<dvec3> origin_;
    Versioned<bool> sky_rays_;
};

}  // namespace lanthorn::gi
