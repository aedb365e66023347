// What can be set of `drm`: gi.drm.*, declared with unit, range and cost in drm_settings.cpp.
#pragma once

namespace lanthorn::gi {

class SettingList;

// How the solid angle of a sample is approximated (solid_angle.glsl); the shaders know them by number.
enum class SolidAngle { eq_14, disc, eq_15, eq_11 };
// What of a sample is the mean over its cell of the light's picture; likewise.
enum class DrmMips { all, light, none };
// What mirrors show of the room's own light (Frisvad et al. 2005, Fig. 8): all, direct light alone (a),
// direct light and the mirror itself lit as if it were matt (b).
enum class DrmMirrors { all, direct, trick };

struct DrmSettings {
    int samples = 3;  // M: M x M of each light's picture
    SolidAngle solid_angle = SolidAngle::disc;
    DrmMips mips = DrmMips::all;
    int texels = 64;  // w: a side of each light's picture
    int lights = 8;   // that have pictures, at most
    DrmMirrors mirrors = DrmMirrors::all;

    bool operator==(const DrmSettings&) const = default;
};

void declare_drm_settings(SettingList& list);

// Whether samples that were made with one are what the other would have made.
bool same_samples(const DrmSettings& a, const DrmSettings& b);

}  // namespace lanthorn::gi
