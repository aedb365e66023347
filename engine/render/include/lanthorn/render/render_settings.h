// What can be chosen about direct light and the picture.
#pragma once

namespace lanthorn {
class Settings;
class SettingsSchema;
}  // namespace lanthorn

namespace lanthorn::render {

enum class ExposureMode { automatic, manual };
enum class ToneMap { aces, neutral, none };

struct RenderSettings {
    int shadow_resolution = 512;       // texels a side of a punctual light's map; render.shadow.resolution
    int area_lights_max = 4;           // emissive instances that give direct light; render.area_lights.max
    int area_lights_samples = 4;       // points that stand for each; render.area_lights.samples
    int area_lights_resolution = 128;  // texels a side of their maps; render.area_lights.resolution
    ExposureMode exposure_mode = ExposureMode::automatic;  // render.exposure.mode
    float exposure_ev100 = 10;                             // manual mode; render.exposure.ev100
    float exposure_compensation = 0;                       // stops, both modes; render.exposure.compensation
    ToneMap tone_map = ToneMap::aces;                      // render.tone_map
    bool antialias = false;                                // render.antialias
    bool adaptive_detail = true;                           // of subdivision surfaces; render.adaptive_detail

    bool operator==(const RenderSettings&) const = default;
};

void declare_render_settings(SettingsSchema& schema);
RenderSettings render_settings(const Settings& settings);

}  // namespace lanthorn::render
