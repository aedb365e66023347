#include "lanthorn/emc/emc_settings.h"

#include "lanthorn/gi/setting_list.h"

namespace lanthorn::gi {

namespace {

void declare_caustics(SettingList& list) {
    list.declare<&EmcSettings::caustic_photons>("gi.caustics.photons")
        .unit("photons")
        .range(0, 4'000'000)
        .presets({10'000, 40'000, 100'000, 400'000})
        .as_published(89'000)
        .cost("linear in ms of caustic photons and their splats, when light or geometry changes")
        .docs(
            "emc: photons sent towards metals that mirror and things that light goes through, all lights "
            "together: by exact rays, or through the maps with gi.emc.rays = maps and in a program without "
            "exact "
            "rays. 0: no caustics.");
    list.declare<&EmcSettings::caustic_c0>("gi.caustics.c0")
        .range(0.1f, 100.0f)
        .cost("quadratic in ms of their splats")
        .docs(
            "Splat radius of caustic photons in units of 1 / sqrt(photons a square metre) around each. "
            "Small: noise; large: blur.");
}

void declare_maps(SettingList& list) {
    list.declare<&EmcSettings::count>("gi.emc.count")
        .unit("maps")
        .range(1, 32)
        .presets({6, 8, 8, 12})
        .as_published(8)
        .cost("linear in ms when geometry changes, and in MB; maps that add no area are not drawn")
        .docs("k: environment maps that stand for the scene, at most.");
    list.declare<&EmcSettings::reserved>("gi.emc.reserved")
        .unit("maps")
        .range(0, 2)
        .presets({0, 0, 2, 2})
        .as_published(0)
        .cost("a map each, once rays of the picture have met what no map shows; some 10 % of a lamp's ms")
        .docs(
            "Maps beside those, of the gather with exact rays: each in the middle of what most rays of the "
            "picture have met and no other map shows, behind furniture or in an alcove. None where there is "
            "no such place.");
    list.declare<&EmcSettings::candidates>("gi.emc.candidates")
        .unit("points")
        .range(1, 64)
        .as_published(40)
        .cost("linear in ms of the first selection and of each progressive update")
        .docs("Size of U: candidate centres, kept out of solids, that the maps are chosen from.");
    list.declare<&EmcSettings::kept>("gi.emc.kept")
        .unit("MiB")
        .range(0, 65536)
        .cost("3 MB a map at 128 texels; a map that comes back is copied instead of drawn")
        .docs(
            "In levels of many rooms: GPU memory for maps of rooms that the camera has left, and for what "
            "rays from them have met. Those used longest ago go first. 0: none is kept.");
    list.declare<&EmcSettings::resolution>("gi.emc.resolution")
        .unit("texels")
        .range(16, 1024)
        .presets({128, 128, 128, 192})
        .cost(
            "quadratic in MB (4 MB a map at 128, half of it what stands still) and in fill when geometry "
            "changes")
        .docs("Side of a map's cube face. Small things between texels are missed by photons.");
    list.declare<&EmcSettings::update_interval>("gi.emc.update_interval")
        .unit("frames")
        .range(1, 1000)
        .as_published(5)
        .cost("inverse in ms while geometry changes")
        .docs(
            "Frames from one progressive update of the chosen centres to the next, while geometry changes "
            "and until "
            "one changes nothing.");
    list.declare<&EmcSettings::fade_frames>("gi.emc.fade_frames")
        .unit("frames")
        .range(0, 60)
        .as_published(0)
        .cost("photons are traced again in each of them")
        .docs(
            "Frames over which an exchanged map takes over from the old one; at most gi.emc.update_interval "
            "of them, so "
            "that no update waits.");
}

void declare_rays(SettingList& list) {
    list.declare<&EmcSettings::search>("gi.emc.search")
        .choices({"march", "secant"})
        .as_published(Search::secant)
        .cost(
            "about the same ms; secant misplaces or loses 7 % of the photons in a furnished room, 19 % in a "
            "Cornell box")
        .docs(
            "How a ray meets a map: a bracketed march on the texels' planes, or the paper's false position "
            "on raw distances.");
    list.declare<&EmcSettings::steps>("gi.emc.steps")
        .unit("steps a half turn")
        .range(2, 1024)
        .presets({24, 32, 64, 96})
        .cost("linear in ms of bounces")
        .docs(
            "March steps as a map's centre sees a photon; thin things between two steps are missed. Rays of "
            "gi.emc.final = gather through the maps take three times as many.");
    list.declare<&EmcSettings::exhaustive>("gi.emc.exhaustive")
        .as_published(true)
        .cost("3 to 4 times the ms of bounces")
        .docs(
            "Ask every map for every ray, as the paper does, even when one map has seen the whole segment.");
    list.declare<&EmcSettings::threshold>("gi.emc.threshold")
        .range(1e-7f, 0.1f)
        .as_published(1e-3f)
        .cost("none")
        .docs(
            "Epsilon of eq. 2: a hit whose direction is off the ray by more (1 - cosine) is rejected. The "
            "paper's is 0.001.");
    list.declare<&EmcSettings::final_stage>("gi.emc.final")
        .choices({"splat", "gather"})
        .as_published(EmcFinal::splat)
        .cost(
            "splat: photons, linear; gather: rays, linear, none in a still picture after 16 frames but "
            "gi.accumulate")
        .docs(
            "What makes the picture: splat is photons on it (Yao et al. 2010), gather is rays from a coarse "
            "grid of its points that meet lit environment maps, remembered for 16 frames.");
    list.declare<&EmcSettings::rays>("gi.emc.rays")
        .choices({"maps", "bvh", "fastest"})
        .as_published(EmcRays::maps)
        .cost("bvh: a third of the ms of rays on a CPU, and once the building of an acceleration structure")
        .docs(
            "What the rays of gi.emc.final = gather travel through: maps is the environment maps, bvh the "
            "scene's triangles on the processor (Embree), fastest is what a measurement in the first frame "
            "finds faster here. What they meet is looked up in the lit maps.");
}

void declare_last_round(SettingList& list) {
    list.declare<&EmcSettings::last_round>("gi.emc.last_round")
        .choices({"device", "in_turn", "at_once"})
        .cost("ms of rays through the maps: on an H200 at_once is half of in_turn, on llvmpipe 1.3 times")
        .docs(
            "How rays of gi.emc.final = gather ask all maps, where three could not follow them: map after "
            "map "
            "in one "
            "invocation until one knows, or in an invocation for each; device: at_once on a GPU.");
}

void declare_gather(SettingList& list) {
    list.declare<&EmcSettings::gather_grid>("gi.gather.grid")
        .unit("pixels")
        .range(1, 64)
        .presets({6, 4, 2, 2})
        .cost("inverse square in ms of gather and filter")
        .docs(
            "Pixels between the points that rays are shot from, at most (gi.gather.points); light is "
            "interpolated between them.");
    list.declare<&EmcSettings::gather_points>("gi.gather.points")
        .unit("points")
        .range(1, 1'000'000)
        .cost("in small pictures linear in ms of gather and filter")
        .docs(
            "The grid of gi.gather.grid is made finer in small pictures, down to a pixel, to have as many.");
    list.declare<&EmcSettings::gather_rays>("gi.gather.rays")
        .unit("rays")
        .range(1, 256)
        .presets({4, 4, 8, 16})
        .cost("linear in ms of gather; 64 bytes a point each")
        .docs("Rays a point of the grid and frame; the last 16 frames' are remembered.");
    list.declare<&EmcSettings::gather_texels>("gi.gather.texels")
        .unit("texels")
        .range(16, 256)
        .presets({48, 64, 64, 96})
        .cost("quadratic in ms of lit maps")
        .docs(
            "Side of a lit map's cube face, at most gi.emc.resolution: how finely light on what rays meet is "
            "known. A multiple of 16 is taken, the next below.");
    list.declare<&EmcSettings::gather_guide>("gi.gather.guide")
        .cost("8 to 24 % of the ms of frames whose view changes")
        .docs(
            "More of the gather's rays go where light came from, and count for less: less noise where light "
            "comes round a corner.");
    list.declare<&EmcSettings::gather_source>("gi.gather.source")
        .choices({"rays", "photons"})
        .cost("see gi.gather.photons; rays: less where light alone changes, more where surfaces move")
        .docs(
            "Where the lit maps' own indirect light comes from: rays from their texels, remembered; or "
            "photons that land on them "
            "(Yao et al. 2010). Light of a sky comes by rays.");
    list.declare<&EmcSettings::gather_photons>("gi.gather.photons")
        .unit("photons")
        .range(1, 4'000'000)
        .presets({1'500, 2'000, 4'000, 8'000})
        .cost("linear in ms of each frame whose light changes, and of 15 after it")
        .docs("Photons that the lamps send to the lit maps in a frame, with gi.gather.source = photons.");
    list.declare<&EmcSettings::gather_endless>("gi.gather.endless")
        .cost("less than a third bounce")
        .docs(
            "gi.emc.final = gather: light is reflected on and on, once more a frame, instead of gi.bounces "
            "times, as in nature. Surfaces that reflect more than 0.95 are taken for ones that reflect that. "
            "false: for "
            "comparison with what counts its bounces.");
    list.declare<&EmcSettings::specular_grid>("gi.specular.grid")
        .unit("pixels")
        .range(1, 4)
        .presets({2, 1, 1, 1})
        .cost("inverse square in ms of mirrors and glass, but for their rims")
        .docs(
            "Pixels between those that have a ray of what they mirror or show. Those between take the mean "
            "of the rays around them on the same surface, or have their own where there is none.");
}

void declare_splats(SettingList& list) {
    list.declare<&EmcSettings::splat_bandwidth>("gi.emc.splat.bandwidth")
        .choices({"variable", "fixed"})
        .as_published(Bandwidth::variable)
        .cost("none")
        .docs("Splat radius: by each photon's own density (sec. 6), or the same for all.");
    list.declare<&EmcSettings::splat_glossy>("gi.emc.splat.glossy")
        .choices({"none", "variable", "fixed"})
        .as_published(GlossyBandwidth::variable)
        .cost("ms by glossy pixels times photons around each; 4 bytes a photon and bounce")
        .docs(
            "gi.emc.final = splat: how photons light the lobes of glossy surfaces (roughness 0.15 to 0.75), "
            "each by the direction in which "
            "it has come, at full size: by splats as wide as photons are far apart (sec. 6, Fig. 8), or all "
            "equally wide. none: irradiance "
            "and rays light them.");
    list.declare<&EmcSettings::splat_c0>("gi.emc.splat.c0")
        .range(0.1f, 100.0f)
        .presets({8.0f, 8.0f, 9.0f, 8.5f})
        .cost("quadratic in ms of splats")
        .docs(
            "C0 of sec. 6: radius in units of sqrt(area / photons); from 20 000 photons on it grows as the "
            "fifth root of their number. Small: noise; large: blur.");
    list.declare<&EmcSettings::splat_base>("gi.emc.splat.base")
        .choices({"1", "2", "4", "8", "16"})
        .presets({SplatBase::sixteenth, SplatBase::sixteenth, SplatBase::eighth, SplatBase::quarter})
        .cost("inverse square in ms of splats")
        .docs(
            "Side of the lowest level's pixels; irradiance is up-sampled from there, discontinuities "
            "computed at each level.");
    list.declare<&EmcSettings::splat_contrast>("gi.emc.splat.contrast")
        .range(0.0f, 1.0f)
        .cost("the smaller, the more pixels are computed instead")
        .docs("Relative difference between coarse neighbours above which a pixel is not interpolated.");
}

}  // namespace

void declare_emc_settings(SettingList& list) {
    declare_caustics(list);
    declare_maps(list);
    declare_rays(list);
    declare_last_round(list);
    declare_gather(list);
    declare_splats(list);
}

}  // namespace lanthorn::gi
