// What can be chosen about direct light and the picture.
#pragma once

namespace lanthorn {
class Settings;
class SettingsSchema;
}  // namespace lanthorn

namespace lanthorn::render {

// automatic: the picture's average luminance becomes middle grey; manual: exposure_ev100 says.
enum class ExposureMode { automatic, manual };
// The factor from nits to display-linear of a manual exposure: 1.2 * 2^EV nits are shown as 1, as ISO 2720
// has it with the usual saturation-based speed.
float exposure_of_ev100(float ev100);
// The EV100 of such a factor, -129..126: what is not above 0 counts as the smallest there is, and a NaN
// likewise.
double ev100_of_exposure(double exposure);
// From exposed light to the screen: ACES filmic, Khronos PBR Neutral, or a plain clamp.
enum class ToneMap { aces, neutral, none };
// How a picture of which fewer pixels are drawn than it has gets the others: by the window that scales it,
// from its own frame along edges, or from the frames before as well.
enum class Upscale { none, spatial, temporal };
// The stage that works on every pixel of a frame: by_device is compute on a GPU and fragment on the
// processor.
enum class PixelStage { by_device, fragment, compute };

struct RenderSettings {
    int shadow_resolution = 512;       // texels a side of a punctual light's map; render.shadow.resolution
    bool shadow_kept = true;           // maps in which nothing has moved; render.shadow.kept
    bool still_kept = true;            // pictures in which nothing has changed; render.still.kept
    int area_lights_max = 4;           // emissive surfaces with so many points each; render.area_lights.max
    int area_lights_samples = 4;       // points of a flat surface; render.area_lights.samples
    int area_lights_resolution = 128;  // texels a side of their maps; render.area_lights.resolution
    float lamps_error = 1e-3f;         // of groups of lamps, share of their light; render.lamps.error
    ExposureMode exposure_mode = ExposureMode::automatic;  // render.exposure.mode
    float exposure_ev100 = 10;                             // manual mode; render.exposure.ev100
    float exposure_compensation = 0;                       // stops, both modes; render.exposure.compensation
    float exposure_darkest = 0.001f;                       // nits, automatic mode; render.exposure.darkest
    float exposure_glide = 0.05f;                          // share of the way a frame; render.exposure.glide
    ToneMap tone_map = ToneMap::aces;                      // render.tone_map
    float shoulder = 0;                                    // of white; render.shoulder
    float bloom_share = 0;            // of light that is scattered around in the picture; render.bloom.share
    float bloom_spread = 0.75f;       // of it that goes on to each wider ring; render.bloom.spread
    float rim = 0;                    // optical depth of fuzz on what has it; render.rim
    float air_scattering = 0;         // 1/m; render.air.scattering
    int air_steps = 8;                // places a ray and light; render.air.steps
    bool antialias = false;           // render.antialias
    Upscale upscale = Upscale::none;  // render.upscale
    float upscale_scale = 1;          // drawn share of the picture's width and height; render.upscale.scale
    float upscale_sharpness = 0.5f;   // 0..1; render.upscale.sharpness
    PixelStage pixel_stage = PixelStage::by_device;  // render.pixel_stage
    bool adaptive_detail = true;                     // of subdivision surfaces; render.adaptive_detail

    bool operator==(const RenderSettings&) const = default;
};

// Declares them as render.*, with units, ranges, defaults and presets. Throws std::logic_error if they are
// there already.
void declare_render_settings(SettingsSchema& schema);
// As they are now. Throws std::logic_error if they were not declared.
RenderSettings render_settings(const Settings& settings);

}  // namespace lanthorn::render
