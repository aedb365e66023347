#include "lanthorn/gi/gi_settings.h"

#include "lanthorn/core/settings.h"

namespace lanthorn::gi {

namespace {

void declare_coarse_settings(SettingsSchema& schema) {
    const CoarseSettings d;
    schema.declare<Spacing>("gi.coarse.grid")
        .choices({"1", "2", "4", "8", "16"})
        .initially(d.grid)
        .presets({Spacing::eight, Spacing::four, Spacing::four, Spacing::two})
        .cost("inverse square in ms of paths and filter")
        .docs(
            "coarse-path: pixels between the points that light is computed at; where none of them lies on a "
            "pixel's surface, a point is added.");
    schema.declare<float>("gi.coarse.samples")
        .unit("paths a point a frame")
        .range(0.125f, 1024.0f)
        .initially(d.samples)
        .presets({2.0f, 2.0f, 8.0f, 8.0f})
        .cost("linear in ms of paths")
        .docs("coarse-path: mean number; noisy and newly seen places get more.");
    schema.declare<int>("gi.coarse.history")
        .unit("frames")
        .range(1, 1000)
        .initially(d.history)
        .cost("none")
        .docs(
            "coarse-path: frames whose samples are kept while light or geometry changes. Few: noise and "
            "flicker; many: light lags behind.");
    schema.declare<int>("gi.coarse.still_history")
        .unit("frames")
        .range(1, 1000)
        .initially(d.still_history)
        .cost("once a still picture has so many, nothing more is traced")
        .docs(
            "coarse-path: the same while only the camera moves, or nothing; gi.accumulate if that is more.");
    schema.declare<int>("gi.coarse.filter")
        .unit("levels")
        .range(0, 6)
        .initially(d.filter)
        .cost("linear in ms of the filter")
        .docs("coarse-path: levels of the a-trous filter; each reaches twice as far as the last.");
    schema.declare<float>("gi.coarse.sigma")
        .unit("standard deviations")
        .range(0.1f, 1000.0f)
        .initially(d.sigma)
        .cost("none")
        .docs("coarse-path: difference in luminance that the filter averages over. Large: blur.");
    schema.declare<int>("gi.coarse.threads")
        .unit("threads")
        .range(0, 1024)
        .initially(d.threads)
        .cost("inverse in ms of paths; 0: as many as there are cores")
        .docs("coarse-path: threads that trace. Never changes the picture.");
}

CoarseSettings coarse_settings(const Settings& s) {
    CoarseSettings c;
    c.grid = s.get<Spacing>("gi.coarse.grid");
    c.samples = s.get<float>("gi.coarse.samples");
    c.history = s.get<int>("gi.coarse.history");
    c.still_history = s.get<int>("gi.coarse.still_history");
    c.filter = s.get<int>("gi.coarse.filter");
    c.sigma = s.get<float>("gi.coarse.sigma");
    c.threads = s.get<int>("gi.coarse.threads");
    return c;
}

}  // namespace

void declare_gi_settings(SettingsSchema& schema) {
    const GiSettings d;
    schema.declare<TechniqueKind>("gi.technique")
        .choices({"emc", "none", "path", "coarse-path"})
        .initially(d.technique)
        .cost("emc, coarse-path: see docs/measurements.md; none: nothing; path: seconds to hours")
        .docs(
            "Indirect light: emc is multi-image photon tracing (Yao et al. 2010), none is direct light "
            "alone, path is the path-traced reference (lanthorn render only), coarse-path traces paths from "
            "a "
            "coarse grid of the picture on the processor and filters them (Schied et al. 2017).");
    schema.declare<int>("gi.bounces")
        .unit("reflections")
        .range(1, 8)
        .initially(d.bounces)
        .presets({2, 2, 3, 4})
        .cost("linear in ms of bounces and splats")
        .docs(
            "Reflections before the visible surface; the light that arrives after exactly 1..N of them is "
            "indirect.");
    schema.declare<int>("gi.photons")
        .unit("photons")
        .range(1, 4'000'000)
        .initially(d.photons)
        .presets({6'000, 20'000, 60'000, 250'000})
        .cost("linear in ms; 56 bytes and 32 more a bounce each, and the splats' lists")
        .docs("Photons emitted, all lights together, split over them by flux.");
    schema.declare<int>("gi.seed")
        .range(0, 1'000'000'000)
        .initially(static_cast<int>(d.seed))
        .cost("none")
        .docs("Seed of the photons and of the candidates. The same seed gives the same picture.");
    schema.declare<int>("gi.accumulate")
        .unit("passes")
        .range(1, 100'000)
        .initially(d.accumulate)
        .cost("linear in ms while nothing moves: one pass a frame, none after the last")
        .docs(
            "While scene and camera stay still, each frame adds other photons with smaller splats to the "
            "mean of "
            "those before (Knaus and Zwicker 2011), up to so many passes; their lowest level has pixels of 4 "
            "at "
            "most.");
    schema.declare<int>("gi.emc.count")
        .unit("maps")
        .range(1, 32)
        .initially(d.emc_count)
        .presets({6, 8, 8, 12})
        .cost("linear in ms when geometry changes, and in MB; maps that add no area are not drawn")
        .docs("k: environment maps that stand for the scene, at most.");
    schema.declare<int>("gi.emc.candidates")
        .unit("points")
        .range(1, 64)
        .initially(d.emc_candidates)
        .cost("linear in ms of the first selection and of each progressive update")
        .docs("Size of U: candidate centres, kept out of solids, that the maps are chosen from.");
    schema.declare<int>("gi.emc.resolution")
        .unit("texels")
        .range(16, 1024)
        .initially(d.emc_resolution)
        .presets({128, 128, 128, 192})
        .cost(
            "quadratic in MB (4 MB a map at 128, half of it what stands still) and in fill when geometry "
            "changes")
        .docs("Side of a map's cube face. Small things between texels are missed by photons.");
    schema.declare<Search>("gi.emc.search")
        .choices({"march", "secant"})
        .initially(d.emc_search)
        .cost("about the same ms; secant misplaces or loses a quarter of the photons and more")
        .docs(
            "How a ray meets a map: a bracketed march on the texels' planes, or the paper's false position "
            "on raw distances.");
    schema.declare<int>("gi.emc.steps")
        .unit("steps a half turn")
        .range(2, 1024)
        .initially(d.emc_steps)
        .presets({24, 32, 64, 96})
        .cost("linear in ms of bounces")
        .docs("March steps as a map's centre sees the ray; thin things between two steps are missed.");
    schema.declare<bool>("gi.emc.exhaustive")
        .initially(d.emc_exhaustive)
        .cost("3 to 4 times the ms of bounces")
        .docs(
            "Ask every map for every ray, as the paper does, even when one map has seen the whole segment.");
    schema.declare<float>("gi.emc.threshold")
        .range(1e-7f, 0.1f)
        .initially(d.emc_threshold)
        .cost("none")
        .docs(
            "Epsilon of eq. 2: a hit whose direction is off the ray by more (1 - cosine) is rejected. The "
            "paper's is 0.001.");
    schema.declare<int>("gi.emc.update_interval")
        .unit("frames")
        .range(1, 1000)
        .initially(d.emc_update_interval)
        .cost("inverse in ms while geometry changes")
        .docs("Frames between progressive updates of the chosen centres while geometry changes.");
    schema.declare<int>("gi.emc.fade_frames")
        .unit("frames")
        .range(0, 60)
        .initially(d.emc_fade_frames)
        .cost("photons are traced anew in each of them")
        .docs("Frames over which an exchanged map takes over from the old one.");
    schema.declare<EmcFinal>("gi.emc.final")
        .choices({"splat", "gather"})
        .initially(d.emc_final)
        .cost("splat: photons, linear; gather: rays, linear, none in a still picture after 16 frames")
        .docs(
            "What makes the picture: splat is photons on it (Yao et al. 2010), gather is rays from a coarse "
            "grid of its points that meet lit environment maps, remembered for 16 frames.");
    schema.declare<EmcRays>("gi.emc.rays")
        .choices({"maps", "bvh"})
        .initially(d.emc_rays)
        .cost("bvh: a tenth of the ms of rays on a CPU, and once the building of an acceleration structure")
        .docs(
            "What the rays of gi.emc.final = gather travel through: maps is the environment maps, bvh the "
            "scene's triangles on the processor (Embree). What they meet is looked up in the lit maps.");
    schema.declare<int>("gi.gather.grid")
        .unit("pixels")
        .range(1, 64)
        .initially(d.gather_grid)
        .presets({6, 4, 4, 2})
        .cost("inverse square in ms of gather and filter")
        .docs("Pixels between the points that rays are shot from; light is interpolated between them.");
    schema.declare<int>("gi.gather.rays")
        .unit("rays")
        .range(1, 256)
        .initially(d.gather_rays)
        .presets({4, 4, 8, 16})
        .cost("linear in ms of gather; 64 bytes a point each")
        .docs("Rays a point of the grid and frame; the last 16 frames' are remembered.");
    schema.declare<Bandwidth>("gi.splat.bandwidth")
        .choices({"variable", "fixed"})
        .initially(d.splat_bandwidth)
        .cost("none")
        .docs("Splat radius: by each photon's own density (sec. 6), or the same for all.");
    schema.declare<float>("gi.splat.c0")
        .range(0.1f, 100.0f)
        .initially(d.splat_c0)
        .presets({8.0f, 8.0f, 9.0f, 8.5f})
        .cost("quadratic in ms of splats")
        .docs(
            "C0 of sec. 6: radius in units of sqrt(area / photons); from 20 000 photons on it grows as the "
            "fifth "
            "root of their number. Small: noise; large: blur.");
    schema.declare<SplatBase>("gi.splat.base")
        .choices({"1", "2", "4", "8", "16"})
        .initially(d.splat_base)
        .presets({SplatBase::sixteenth, SplatBase::sixteenth, SplatBase::eighth, SplatBase::quarter})
        .cost("inverse square in ms of splats")
        .docs(
            "Side of the lowest level's pixels; irradiance is up-sampled from there, discontinuities "
            "computed anew.");
    schema.declare<float>("gi.splat.contrast")
        .range(0.0f, 1.0f)
        .initially(d.splat_contrast)
        .cost("the smaller, the more pixels are computed anew")
        .docs("Relative difference between coarse neighbours above which a pixel is not interpolated.");
    declare_coarse_settings(schema);
}

GiSettings gi_settings(const Settings& s) {
    GiSettings g;
    g.technique = s.get<TechniqueKind>("gi.technique");
    g.bounces = s.get<int>("gi.bounces");
    g.photons = s.get<int>("gi.photons");
    g.accumulate = s.get<int>("gi.accumulate");
    g.seed = static_cast<std::uint32_t>(s.get<int>("gi.seed"));
    g.emc_count = s.get<int>("gi.emc.count");
    g.emc_candidates = s.get<int>("gi.emc.candidates");
    g.emc_resolution = s.get<int>("gi.emc.resolution");
    g.emc_search = s.get<Search>("gi.emc.search");
    g.emc_steps = s.get<int>("gi.emc.steps");
    g.emc_exhaustive = s.get<bool>("gi.emc.exhaustive");
    g.emc_threshold = s.get<float>("gi.emc.threshold");
    g.emc_update_interval = s.get<int>("gi.emc.update_interval");
    g.emc_fade_frames = s.get<int>("gi.emc.fade_frames");
    g.emc_rays = s.get<EmcRays>("gi.emc.rays");
    g.emc_final = s.get<EmcFinal>("gi.emc.final");
    g.gather_grid = s.get<int>("gi.gather.grid");
    g.gather_rays = s.get<int>("gi.gather.rays");
    g.splat_bandwidth = s.get<Bandwidth>("gi.splat.bandwidth");
    g.splat_c0 = s.get<float>("gi.splat.c0");
    g.splat_base = s.get<SplatBase>("gi.splat.base");
    g.splat_contrast = s.get<float>("gi.splat.contrast");
    g.coarse = coarse_settings(s);
    return g;
}

std::string technique_name(TechniqueKind kind) {
    switch (kind) {
        case TechniqueKind::emc:
            return "emc";
        case TechniqueKind::none:
            return "none";
        case TechniqueKind::coarse_path:
            return "coarse-path";
        case TechniqueKind::path:
            break;
    }
    return "path";
}

}  // namespace lanthorn::gi
