// What can be set of the indirect light; declared once in gi_settings.cpp with unit, range, default and cost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

namespace lanthorn {
class Settings;
class SettingsSchema;
}  // namespace lanthorn

namespace lanthorn::gi {

// A technique by its place among those that this program knows (technique.h). These are always there: `first`
// is the default, the first that is registered. Others have the value that add_technique() returned.
enum class TechniqueKind : int { first, none, path };
enum class SplatBase {
    full,
    half,
    quarter,
    eighth,
    sixteenth
};  // 1 << value: side of a pixel in full-size pixels
enum class Search { march, secant };
enum class Bandwidth { variable, fixed };
enum class EmcFinal { splat, gather };
enum class EmcRays { maps, bvh, fastest };
enum class GatherSource { rays, photons };

// Settings that techniques keep in types of their own, one of a type. Copies share them until they are
// edited.
class SettingParts {
  public:
    // One with its defaults where there is none. O(parts).
    template <typename Part>
    const Part& of() const {
        for (const auto& [type, part] : parts_) {
            if (type == std::type_index(typeid(Part))) {
                return *static_cast<const Part*>(part.get());
            }
        }
        static const Part kDefaults;
        return kDefaults;
    }

    // Holds until a copy of these is made.
    template <typename Part>
    Part& edit() {
        auto own = std::make_shared<Part>(of<Part>());
        Part& result = *own;
        for (auto& [type, part] : parts_) {
            if (type == std::type_index(typeid(Part))) {
                part = std::move(own);
                return result;
            }
        }
        parts_.emplace_back(std::type_index(typeid(Part)), std::move(own));
        return result;
    }

  private:
    std::vector<std::pair<std::type_index, std::shared_ptr<const void>>> parts_;
};

struct GiSettings {
    TechniqueKind technique = TechniqueKind::first;
    int bounces = 2;      // reflections before the visible surface
    int photons = 20000;  // emitted a frame, all lights together
    std::uint32_t seed = 1;

    int emc_count = 8;         // k
    int emc_reserved = 0;      // maps beside them, where rays of the picture lack one
    int emc_candidates = 40;   // size of U
    int emc_kept = 64;         // MiB of maps of rooms left behind
    int emc_resolution = 128;  // texels a cube-face edge
    Search emc_search = Search::march;
    int emc_steps = 32;           // march steps a half turn as seen from a map
    bool emc_exhaustive = false;  // ask all maps even when one has seen the whole segment
    float emc_threshold = 1e-4f;  // epsilon of Yao et al. 2010, eq. 2 (the paper's 1e-3 is for its secant)
    int emc_update_interval = 5;  // frames between progressive updates while geometry changes
    int emc_fade_frames = 4;      // frames an exchanged map takes to fade over

    EmcRays emc_rays = EmcRays::fastest;
    EmcFinal emc_final = EmcFinal::gather;  // the stage that makes the picture
    int gather_grid = 4;                    // pixels between the points that rays are shot from, at most
    int gather_points = 6000;               // at least, where there are as many pixels
    int gather_rays = 4;                    // a point and frame
    int gather_texels = 64;                 // a side of a lit map's cube face
    GatherSource gather_source = GatherSource::rays;  // of indirect light on the lit maps
    int gather_photons = 2000;                        // a frame, of that source
    bool gather_guide = true;                         // rays go where light came from
    bool gather_endless = true;                       // light goes on being reflected, whatever `bounces` is

    float specular_roughness = 0.5f;  // of the roughest surface whose specular lobe is traced; 0: none
    int specular_grid = 1;            // pixels a side of which one has a ray, where they show one surface

    Bandwidth splat_bandwidth = Bandwidth::variable;
    float splat_c0 = 8.0f;  // C0 of sec. 6
    int accumulate = 1;     // passes that a still picture is made of; 1: the first one stays
    SplatBase splat_base = SplatBase::sixteenth;
    float splat_contrast =
        0.65f;  // relative difference between coarse neighbours above which a pixel is computed anew

    int caustic_photons = 40'000;  // emitted towards mirrors and glass, all lights together
    float caustic_c0 = 4.0f;       // splat radius in units of the distance between photons

    // Of other techniques: settings.of<CoarseSettings>().samples, settings.edit<CoarseSettings>().samples
    // = 4.
    template <typename Part>
    const Part& of() const {
        return parts.of<Part>();
    }
    template <typename Part>
    Part& edit() {
        return parts.edit<Part>();
    }
    SettingParts parts;
};

// What a change of settings makes anew. What is made from that follows by itself. Techniques compare what
// they keep in types of their own themselves.
struct Renewal {
    // Of `emc`.
    bool maps = false;         // chosen and drawn
    bool round = false;        // of the progressive update
    bool photons = false;      // traced
    bool lit_maps = false;     // lit, and what their rays met
    bool lit_photons = false;  // that light them, with gi.gather.source = photons
    bool image = false;        // splats or gather
    bool points = false;       // what the gather's rays met
    bool specular = false;     // what mirrors and glass show
    bool caustics = false;     // caustic photons
    // Of every other technique.
    bool samples = false;  // all that it has traced

    Renewal& operator|=(const Renewal& o) {
        maps |= o.maps;
        round |= o.round;
        photons |= o.photons;
        lit_maps |= o.lit_maps;
        lit_photons |= o.lit_photons;
        image |= o.image;
        points |= o.points;
        specular |= o.specular;
        caustics |= o.caustics;
        samples |= o.samples;
        return *this;
    }
};

// Those of every technique that this program knows by then.
void declare_gi_settings(SettingsSchema& schema);
GiSettings gi_settings(const Settings& settings);
// By what the settings' declarations say. Another technique is made anew by whoever asks for it.
Renewal renewed(const GiSettings& before, const GiSettings& now);

}  // namespace lanthorn::gi
