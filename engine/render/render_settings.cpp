#include "lanthorn/render/render_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lanthorn/core/settings.h"

namespace lanthorn::render {

namespace {

constexpr double kWhiteNits = 1.2;  // at EV100 0

}  // namespace

float exposure_of_ev100(float ev100) {
    return 1 / (static_cast<float>(kWhiteNits) * std::exp2(ev100));
}

double ev100_of_exposure(double exposure) {
    using Limits = std::numeric_limits<float>;
    // Of a NaN, max() returns the first.
    const double factor =
        std::min(std::max(static_cast<double>(Limits::min()), exposure), static_cast<double>(Limits::max()));
    return -std::log2(kWhiteNits * factor);
}

void declare_render_settings(SettingsSchema& schema) {
    const RenderSettings d;
    schema.declare<int>("render.shadow.resolution")
        .unit("texels")
        .range(16, 4096)
        .initially(d.shadow_resolution)
        .presets({256, 512, 512, 1024})
        .cost(
            "quadratic in MB (12 bytes a texel, 1 or 6 faces a light) and in ms when a light or what it sees "
            "moves")
        .docs(
            "Side of a map of a point, spot or directional light: its shadows, and where its photons start.");
    schema.declare<bool>("render.shadow.kept")
        .initially(d.shadow_kept)
        .for_measuring()
        .cost("false draws every map of a light that shines in every frame")
        .docs("For measuring the plan (docs/plan.md). False: no map is kept from frame to frame.");
    schema.declare<bool>("render.still.kept")
        .initially(d.still_kept)
        .for_measuring()
        .cost("false draws the G-buffer and direct light in every frame")
        .docs(
            "For measuring the plan (docs/plan.md). False: they are not kept while neither the view nor what "
            "it shows changes.");
    schema.declare<int>("render.area_lights.max")
        .unit("surfaces")
        .range(0, 64)
        .initially(d.area_lights_max)
        .cost("linear in ms")
        .docs(
            "Emissive surfaces that have `render.area_lights.samples` points each: with it the points that "
            "stand "
            "for all. Of more surfaces each has at least one, and beyond 64 the weakest share 16. 0: "
            "emissive "
            "surfaces give no direct light.");
    schema.declare<int>("render.area_lights.samples")
        .unit("points a surface")
        .range(1, 256)
        .initially(d.area_lights_samples)
        .presets({1, 4, 4, 16})
        .cost("linear in ms")
        .docs(
            "Points that stand for a flat emissive surface, and three times as many for one that shines to "
            "all "
            "sides; few give stepped penumbras.");
    schema.declare<int>("render.area_lights.resolution")
        .unit("texels")
        .range(16, 2048)
        .initially(d.area_lights_resolution)
        .presets({64, 128, 256, 256})
        .cost("quadratic in MB (48 bytes a texel and point, 72 more where something moves) and in ms then")
        .docs("Side of the shadow maps of the points on emissive surfaces.");
    schema.declare<float>("render.lamps.error")
        .range(0.0f, 0.1f)
        .initially(d.lamps_error)
        .cost("0: linear in ms and lamps; else by its fourth root, and by the logarithm of their number")
        .docs(
            "Where a scene has more than 128 lights: how much a group of point lamps that shading takes for "
            "one may be off, as a "
            "share of the group's own light where nothing shades it. 0: every lamp is added up alone.");
    schema.declare<ExposureMode>("render.exposure.mode")
        .choices({"auto", "manual"})
        .initially(d.exposure_mode)
        .cost("none")
        .docs("auto: the picture's average luminance becomes middle grey; manual: render.exposure.ev100.");
    schema.declare<float>("render.exposure.ev100")
        .unit("EV at ISO 100")
        .range(-20.0f, 40.0f)
        .initially(d.exposure_ev100)
        .cost("none")
        .docs("Manual exposure: 1.2 * 2^EV nits are shown as white.");
    schema.declare<float>("render.exposure.compensation")
        .unit("stops")
        .range(-20.0f, 20.0f)
        .initially(d.exposure_compensation)
        .cost("none")
        .docs("Brighter (positive) or darker than the exposure says.");
    schema.declare<float>("render.exposure.darkest")
        .unit("nits")
        .range(1e-6f, 1e6f)
        .initially(d.exposure_darkest)
        .cost("none")
        .docs(
            "auto: an average below this is shown as dark as it is, with the exposure of this one; "
            "lamplighter's is 0.1, so that its nights stay dark.");
    schema.declare<float>("render.exposure.glide")
        .unit("of the way in stops, a frame")
        .range(0.0f, 1.0f)
        .initially(d.exposure_glide)
        .cost("none")
        .docs(
            "auto: how fast the exposure follows what is seen; the first frame takes it at once. lamplighter "
            "sets it by the time that a frame took.");
    schema.declare<ToneMap>("render.tone_map")
        .choices({"aces", "neutral", "none"})
        .initially(d.tone_map)
        .cost("none")
        .docs("From exposed light to the screen: ACES filmic, Khronos PBR Neutral, or a plain clamp.");
    schema.declare<float>("render.shoulder")
        .unit("of white")
        .range(0.0f, 100.0f)
        .initially(d.shoulder)
        .cost("none")
        .docs(
            "How far what is brighter than white stays apart before it is tone mapped: of m times white "
            "there "
            "stays 1 + w ln(1 + (m - 1) / w), of the same hue, so that the wall behind a lamp keeps its "
            "colour and its shades. 0: as the tone map alone has it. lamplighter's is 0.5.");
    schema.declare<float>("render.bloom.share")
        .range(0.0f, 1.0f)
        .initially(d.bloom_share)
        .cost("0: none; else linear in pixels")
        .docs(
            "Share of the picture's light that is scattered around where it is seen, as by eye and lens: "
            "what "
            "is bright has a halo of its own hue. The sum of light stays; exposure is measured without it. "
            "lamplighter's is 0.1.");
    schema.declare<float>("render.bloom.spread")
        .range(0.0f, 1.0f)
        .initially(d.bloom_spread)
        .cost("none")
        .docs(
            "Share of the scattered light that each ring of the halo hands on to the next, twice as wide; 0: "
            "none goes beyond 8 pixels.");
    schema.declare<float>("render.rim")
        .range(0.0f, 1.0f)
        .initially(d.rim)
        .cost("0: none; else linear in the pixels of figures")
        .docs(
            "Optical depth of a fuzz on what a program says has one (lamplighter: its figures; no other "
            "does): "
            "light from behind and around shines along its outline. In the picture alone: exposure, maps, "
            "sensors and path know nothing of it. lamplighter's is 0.2.");
    schema.declare<float>("render.air.scattering")
        .unit("1/m")
        .range(0.0f, 0.2f)
        .initially(d.air_scattering)
        .cost("0: none; else linear in pixels, steps and lamps")
        .docs(
            "Light of point, spot and directional lamps that thin air scatters towards the eye, once and "
            "evenly to all sides, in the shadow of their maps: beams are seen on their way. What air takes "
            "from light on its way is left out.");
    schema.declare<int>("render.air.steps")
        .unit("places")
        .range(1, 64)
        .initially(d.air_steps)
        .cost("linear in ms of air")
        .docs("Where along a ray of the picture each lamp's light in air is asked for.");
    schema.declare<bool>("render.antialias")
        .initially(d.antialias)
        .cost("linear in pixels on edges")
        .docs(
            "Edges in the finished picture are smoothed (FXAA); lamplighter does so unless told otherwise. "
            "The "
            "path tracer's counterpart is path.antialias.");
    schema.declare<Upscale>("render.upscale")
        .choices({"none", "spatial", "temporal"})
        .initially(d.upscale)
        .cost("none: none; else linear in the picture's pixels, not in those that are drawn")
        .docs(
            "Where fewer pixels are drawn than the picture has (render.upscale.scale, a window's frame "
            "budget): spatial finds the others along the edges of the frame; temporal also from the frames "
            "before, which look through other places of each pixel, and smooths edges in place of "
            "render.antialias. The windows of lamplighter and the editor have temporal.");
    schema.declare<float>("render.upscale.scale")
        .range(0.1f, 1.0f)
        .initially(d.upscale_scale)
        .cost("quadratic in ms")
        .docs(
            "Share of the picture's width and height that is drawn where render.upscale is not none; a "
            "window's frame budget takes its share of that.");
    schema.declare<float>("render.upscale.sharpness")
        .range(0.0f, 1.0f)
        .initially(d.upscale_sharpness)
        .cost("none")
        .docs("How much contrast between neighbours is raised after up-scaling; 0: not at all.");
    schema.declare<PixelStage>("render.pixel_stage")
        .choices({"device", "fragment", "compute"})
        .initially(d.pixel_stage)
        .cost("on a GPU of a data centre, few of whose units rasterise, compute is several times faster")
        .docs(
            "Shaders that add up and show the light of every pixel; device: compute shaders on a GPU, "
            "fragment "
            "shaders on the processor.");
    schema.declare<bool>("render.adaptive_detail")
        .initially(d.adaptive_detail)
        .cost("false: up to 4 times the triangles a level, refined each time a cage moves")
        .docs(
            "Subdivision surfaces are refined as finely as the camera and the maps can tell, at most to the "
            "level in their file; false: always to that level.");
}

RenderSettings render_settings(const Settings& s) {
    RenderSettings r;
    r.shadow_resolution = s.get<int>("render.shadow.resolution");
    r.shadow_kept = s.get<bool>("render.shadow.kept");
    r.area_lights_max = s.get<int>("render.area_lights.max");
    r.area_lights_samples = s.get<int>("render.area_lights.samples");
    r.area_lights_resolution = s.get<int>("render.area_lights.resolution");
    r.lamps_error = s.get<float>("render.lamps.error");
    r.exposure_mode = s.get<ExposureMode>("render.exposure.mode");
    r.exposure_ev100 = s.get<float>("render.exposure.ev100");
    r.exposure_compensation = s.get<float>("render.exposure.compensation");
    r.exposure_darkest = s.get<float>("render.exposure.darkest");
    r.still_kept = s.get<bool>("render.still.kept");
    r.exposure_glide = s.get<float>("render.exposure.glide");
    r.shoulder = s.get<float>("render.shoulder");
    r.bloom_share = s.get<float>("render.bloom.share");
    r.bloom_spread = s.get<float>("render.bloom.spread");
    r.rim = s.get<float>("render.rim");
    r.air_scattering = s.get<float>("render.air.scattering");
    r.air_steps = s.get<int>("render.air.steps");
    r.tone_map = s.get<ToneMap>("render.tone_map");
    r.antialias = s.get<bool>("render.antialias");
    r.upscale = s.get<Upscale>("render.upscale");
    r.upscale_scale = s.get<float>("render.upscale.scale");
    r.upscale_sharpness = s.get<float>("render.upscale.sharpness");
    r.pixel_stage = s.get<PixelStage>("render.pixel_stage");
    r.adaptive_detail = s.get<bool>("render.adaptive_detail");
    return r;
}

}  // namespace lanthorn::render
