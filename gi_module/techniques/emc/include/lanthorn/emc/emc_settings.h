// What can be set of `emc` beside what techniques share (gi_settings.h): gi.emc.*, gi.gather.*, gi.caustics.*
// and gi.specular.grid.
#pragma once

namespace lanthorn::gi {

class SettingList;

// gi.emc.splat.base: the lowest level that photons are splatted at. 1 << value is the side of one of its
// pixels in pixels of the picture.
enum class SplatBase { full, half, quarter, eighth, sixteenth };
// gi.emc.search: how a ray finds its hit in a map. `march` steps along it and brackets the crossing of the
// texels' planes; `secant` is false position on raw distances (Yao et al. 2010).
enum class Search { march, secant };
// gi.emc.splat.bandwidth: the radius of splats. `variable`: by the density of photons around each (Yao et al.
// 2010, sec. 6); `fixed`: the same for all.
enum class Bandwidth { variable, fixed };
// gi.emc.splat.glossy: whether photons on the picture light the lobes of glossy surfaces, by splats of their
// own (Yao et al. 2010, sec. 6 and Fig. 8). `none`: irradiance and rays do; `variable`: splats as wide as
// photons are far apart there; `fixed`: the same for all.
enum class GlossyBandwidth { none, variable, fixed };
// gi.emc.final: what makes the picture. `splat`: photons drawn onto it; `gather`: rays from a coarse grid of
// its points that meet lit maps.
enum class EmcFinal { splat, gather };
// gi.emc.rays: what rays of the gather travel through. `maps`: the environment maps; `bvh`: the scene's
// triangles, on the processor; `fastest`: what a measurement in the first frame finds faster.
enum class EmcRays { maps, bvh, fastest };
// gi.emc.last_round: how rays of the gather that three maps could not follow ask all. `in_turn`: one
// invocation asks map after map until one knows, as suits a processor; `at_once`: an invocation for each map,
// as suits a GPU; `device`: either.
enum class LastRound { device, in_turn, at_once };
// gi.gather.source: where the lit maps' own indirect light comes from. `rays`: from their texels, remembered;
// `photons`: those that land on them.
enum class GatherSource { rays, photons };

// Their values, with the defaults; emc_settings.cpp declares each with unit, range and cost.
struct EmcSettings {
    int count = 8;         // k
    int reserved = 0;      // maps beside them, where rays of the picture lack one
    int candidates = 40;   // size of U
    int kept = 64;         // MiB of maps of rooms left behind
    int resolution = 128;  // texels a cube-face edge
    Search search = Search::march;
    int steps = 32;           // march steps a half turn as seen from a map
    bool exhaustive = false;  // ask all maps even when one has seen the whole segment
    float threshold = 1e-4f;  // epsilon of Yao et al. 2010, eq. 2 (the paper's 1e-3 is for its secant)
    int update_interval = 5;  // frames from one progressive update to the next, while there are any
    int fade_frames = 4;      // frames an exchanged map takes to fade over; at most update_interval

    EmcRays rays = EmcRays::fastest;
    LastRound last_round = LastRound::device;
    EmcFinal final_stage = EmcFinal::gather;  // the stage that makes the picture
    int gather_grid = 4;                      // pixels between the points that rays are shot from, at most
    int gather_points = 6000;                 // at least, where there are as many pixels
    int gather_rays = 4;                      // a point and frame
    int gather_texels = 64;                   // a side of a lit map's cube face
    GatherSource gather_source = GatherSource::photons;  // of indirect light on the lit maps
    int gather_photons = 2000;                           // a frame, of that source
    bool gather_guide = true;                            // rays go where light came from
    bool gather_endless = true;  // light goes on being reflected, whatever `bounces` is

    int specular_grid = 1;  // pixels a side of which one has a ray, where they show one surface

    Bandwidth splat_bandwidth = Bandwidth::variable;
    GlossyBandwidth splat_glossy = GlossyBandwidth::none;
    float splat_c0 = 8.0f;  // C0 of sec. 6
    SplatBase splat_base = SplatBase::sixteenth;
    float splat_contrast =
        0.65f;  // relative difference between coarse neighbours above which a pixel is computed anew

    int caustic_photons = 40'000;  // emitted towards mirrors and glass, all lights together
    float caustic_c0 = 4.0f;       // splat radius in units of the distance between photons
};

// Adds all of these to `list`, as TechniqueEntry::declare does.
void declare_emc_settings(SettingList& list);

}  // namespace lanthorn::gi
