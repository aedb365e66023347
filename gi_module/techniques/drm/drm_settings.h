// What can be set of `drm`: gi.drm.*, declared with unit, range and cost in drm_settings.cpp.
#pragma once

namespace lanthorn::gi {

class SettingList;

// How the solid angle of a sample is approximated (solid_angle.glsl); the shaders know them by number.
enum class SolidAngle { eq_14, disc, eq_15, eq_11, eq_13 };
// What of a sample is the mean over its cell of the light's picture; likewise.
enum class DrmMips { all, light, none, radiance };
// What mirrors show of the room's own light (Frisvad et al. 2005, Fig. 8): all, direct light alone (a),
// direct light and the mirror itself lit as if it were matt (b).
enum class DrmMirrors { all, direct, trick };

// What hides a sample from what it would light: nothing, or what stands in the map of distances about it.
enum class DrmVisibility { none, maps };

struct DrmSettings {
    int samples = 3;  // M: M x M of each light's picture
    SolidAngle solid_angle = SolidAngle::disc;
    DrmMips mips = DrmMips::all;
    int texels = 64;  // w: a side of each light's picture
    int lights = 8;   // that have pictures, at most
    DrmMirrors mirrors = DrmMirrors::all;
    DrmVisibility visibility = DrmVisibility::none;
    int second = 0;  // samples a side of what each sample sees, for a second bounce; 0: one bounce

    bool operator==(const DrmSettings&) const = default;
};

void declare_drm_settings(SettingList& list);

// Whether samples that were made with one are what the other would have made.
bool same_samples(const DrmSettings& a, const DrmSettings& b);

// Whether samples have pictures of their own.
inline bool samples_look(const DrmSettings& settings) {
    return settings.visibility == DrmVisibility::maps || settings.second > 0;
}

}  // namespace lanthorn::gi
