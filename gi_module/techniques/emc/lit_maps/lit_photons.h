// Photons on the lit maps: E1 by the density of those that have arrived (Yao et al. 2010, sec. 3 to 7),
// instead of by rays (gi.gather.source). Each is counted by the coarse texel that the surface it met belongs
// to; that texel's area is known, and a kernel over the texels of the same surface around it is as wide as
// photons are few. Nothing crosses what stands between two surfaces: photons arrive where they hit, and
// kernels stay on a face of a map, from texel to texel.
#pragma once

#include <vector>

#include "gi_module/techniques/emc/gather/entry_list.h"
#include "gi_module/techniques/emc/lit_maps/lit_lists.h"
#include "gi_module/techniques/emc/lit_maps/photon_mean.h"
#include "gi_module/techniques/emc/photons/photon_tracing.h"
#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class LitPhotons {
  public:
    // Frames of photons in the mean of a still scene; after them nothing is traced.
    static constexpr int kFrames = PhotonMean::kFrames;

    // What the lit maps are made of.
    struct Texels {
        const EnvironmentMaps& maps;
        const LitTexels& texels;
        const LitLists& lists;
    };

    // No photon is remembered.
    void forget() { in_mean_.forget(); }
    // The maps show other surfaces: which texel counts what, and how large it is. Texels that show what they
    // showed keep their mean. After each look at the maps: what did not change then is not looked at, unless
    // it is to be done for `all`. Cost: four lookups for each lit texel that looked at the maps.
    void look(const Texels& at, const GiSettings& settings, const FrameScene& scene, bool all);
    // A frame more of gi.gather.photons, after 1 to `bounces` reflections each; `endless`: and the light that
    // follows, as if each later bounce kept what the last one did. `changed`: light or surfaces are not those
    // of the frame before; the mean then holds few frames, the fewer the faster lamps move, and none of
    // before where they have got much brighter or dimmer. `looked`: look() has been called; texels that an
    // exchanged map shows have no mean yet. Photons of the emissive triangles that `first_of` marks (uint
    // each; null: none) count where they first arrive, too.
    void trace(const Texels& at, const render::LightInputs& inputs, const GiSettings& settings, int bounces,
               bool endless, bool changed, bool looked, const gpu::Buffer* first_of);
    // Irradiance in lux, vec4 by number of the coarse texel; a < 0: nothing is known.
    const gpu::Buffer& irradiance() const { return irradiance_; }

    int mean_units() const { return in_mean_.units(); }  // of gi.gather.photons behind it, at most
    const PhotonSet& arrived() const { return tracing_.arrived(); }        // of the last trace()
    PhotonStatistics statistics() const { return tracing_.statistics(); }  // slow: reads all photons
    std::uint32_t bad_value_count() const { return tracing_.bad_value_count(); }
    std::size_t bytes() const;

  private:
    void build_programs();
    void resize(const Texels& at);
    void find_homes(const Texels& at, const GiSettings& settings, const FrameScene& scene, bool all);
    void link(const Texels& at, const GiSettings& settings, const FrameScene& scene, bool all);
    void measure(const Texels& at, const GiSettings& settings, const FrameScene& scene);
    void follow_lamps(const render::LightInputs& inputs, const EnvironmentMaps& maps);
    void count(const Texels& at, const render::LightInputs& inputs, const GiSettings& settings, int bounces,
               bool endless, bool first);
    void add_to_mean(const Texels& at, const GiSettings& settings, const FrameScene& scene,
                     const PhotonMean::Frame& frame);
    void widen(const Texels& at, int photons);

    PhotonTracing tracing_;
    int places_ = 0;
    int lit_places_ = 0;
    PhotonMean in_mean_;
    double area_ = 0;  // m^2: what the sums of areas are counted in units of
    dvec3 flux_{0};    // lumen, that the lamps send
    vec3 scale_{1};    // that over what they sent in the frame before
    // By how much the lamp that did most has moved in the frame, of EnvironmentMaps::extent(), or turned, in
    // radians.
    float local_length_ = 1;  // EnvironmentMaps::extent()
    float drift_ = 0;
    std::vector<render::LightData> lamps_;
    vec3 middle_{0};  // of what shines
    // By place of the lit texel: that of the coarse texel which counts its photons, + 1.
    gpu::Buffer homes_;
    EntryList beside_list_;  // lit texels whose own coarse texel shows another surface
    gpu::Buffer parts_;      // vec4, m^2: of its parts, where photons on them find it
    // By place of the coarse texel.
    gpu::Buffer areas_;       // two words
    gpu::Buffer powers_;      // rgb, two words each
    gpu::Buffer seen_;        // vec4: point
    gpu::Buffer age_;         // float
    gpu::Buffer links_;       // uint32
    gpu::Buffer kernels_[4];  // vec4: power and area, from the narrowest to the widest; the first is the mean
    gpu::Buffer irradiance_;
    gpu::Buffer rest_;  // vec4: what a photon of the last bounce stands for
    gpu::Program homes_program_, beside_, areas_program_, support_, splat_, rest_program_, mean_,
        links_program_, widen_, light_;
    gpu::BufferTexture lit_points_view_, index_view_, points_view_, homes_view_, hits_view_, rest_view_,
        areas_view_, links_view_, parts_view_;
    gpu::BufferTexture kernel_views_[4];
};

}  // namespace lanthorn::gi
