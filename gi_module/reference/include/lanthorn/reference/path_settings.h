// What can be set of the path tracer. The technique `path` declares it, with unit, range and cost.
#pragma once

#include <cstdint>
#include <string>

namespace lanthorn {
class Settings;
}  // namespace lanthorn

namespace lanthorn::reference {

// What light does at a surface.
//   diffuse  Lambert reflection of what the material reflects of even light (diffuse_reflectance.h), about
//   the
//            triangle's own normal: exactly the indirect light that `emc` estimates. Blended surfaces are met
//            with the chance of their alpha, always in the same places (alpha_coverage.h).
//   full     everything the material says: GGX, transmission, alpha; volumes of glass and water bend light
//   and
//            absorb it (dielectric.h).
//   automatic  what settled() says.
enum class Transport { diffuse, full, automatic };

// The roughest metal, perceptual, that makes a caustic.
inline constexpr float kRoughestSpecular = 0.4f;

struct PathSettings {
    int spp = 64;            // samples a pixel, at most
    int frame_spp = 1;       // of these: that a frame of a window adds
    float time_limit = 0;    // seconds; 0: none
    float target_noise = 0;  // relative, of the image (see NoiseEstimate); 0: none
    Transport transport = Transport::automatic;
    bool caustics = true;    // of Transport::full
    bool unlimited = false;  // ignore `bounces`: Russian roulette ends paths
    bool antialias = false;  // spread samples over the pixel instead of through its centre
    int bounces = 2;         // gi.bounces: reflections before the visible surface
    std::uint32_t seed = 1;  // gi.seed
    int threads = 0;         // 0: all; never changes the image
};

inline constexpr int kMostSamples = 1'000'000;  // of PathSettings::spp

// What path.* (where they are declared), gi.bounces and gi.seed say. A time limit or a target noise without a
// path.spp of one's own lifts the limit of samples. With path.transport=automatic and gi.bounces as they are
// by default light is followed as far as gi.gather.endless says: `path` and `emc` then show the same.
PathSettings path_settings(const Settings& settings);

// With a transport that is not automatic: where it was, full and unlimited for a picture, whose mirrors and
// glass are to be seen; diffuse where irradiance alone is asked for, which is then measured against
// techniques that count the same light.
PathSettings settled(PathSettings settings, bool picture);

std::string transport_name(Transport transport);  // as in path.transport

}  // namespace lanthorn::reference
