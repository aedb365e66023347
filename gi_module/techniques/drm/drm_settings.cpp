#include "gi_module/techniques/drm/drm_settings.h"

#include "lanthorn/gi/setting_list.h"

namespace lanthorn::gi {

void declare_drm_settings(SettingList& list) {
    list.declare<&DrmSettings::samples>("gi.drm.samples")
        .unit("samples a side")
        .range(1, 16)
        .presets({2, 3, 5, 8})
        .as_published(3)
        .cost("quadratic in ms of the gather")
        .docs("drm: M; each light's picture has M x M samples, which every pixel is lit by.");
    list.declare<&DrmSettings::solid_angle>("gi.drm.solid_angle")
        .choices({"14", "disc", "15", "11", "13"})
        .as_published(SolidAngle::eq_14)
        .cost("15 and 11: a fifth less ms of the gather than 14 and disc")
        .docs(
            "drm: what a sample covers, by the equations of Frisvad et al. 2005: 14 is the area over itself "
            "and "
            "the squared distance; disc is the same with the area over pi beside the squared distance, which "
            "is "
            "exact for a disc; 15 takes the scene's diagonal for the distance; 11 gives all samples the "
            "same; 13 is the area over the squared distance, which knows no bound where a sample is near.");
    list.declare<&DrmSettings::mips>("gi.drm.mips")
        .choices({"all", "light", "none", "radiance"})
        .as_published(DrmMips::radiance)
        .cost("none: less than 0.1 ms less a light, in frames in which light or geometry changes")
        .docs(
            "drm: what of a sample is a mean over its part of the light's picture: all; the light that is "
            "sent on alone, from the place in the middle; nothing, which flashes while something moves; or, "
            "as "
            "Frisvad et al. 2005, sec. 5 advise, the radiance alone, of the place and over the area in the "
            "middle. "
            "Light that mirrors send on needs all.");
    list.declare<&DrmSettings::texels>("gi.drm.texels")
        .unit("texels a side")
        .range(1, 256)
        .cost("quadratic in ms of the samples, in frames in which light or geometry changes")
        .docs(
            "drm: texels of each light's picture, at least one a sample; a sample's mean is of its share of "
            "them.");
    list.declare<&DrmSettings::lights>("gi.drm.lights")
        .unit("pictures")
        .range(1, 256)
        .as_published(1)
        .cost("linear in ms of the gather")
        .docs(
            "drm: lights that have a picture, the strongest first. An emissive surface has one for every way "
            "that it faces.");
    list.declare<&DrmSettings::mirrors>("gi.drm.mirrors")
        .choices({"all", "direct", "trick"})
        .as_published(DrmMirrors::trick)
        .cost("direct and trick: a tenth less ms of mirrors")
        .docs(
            "drm: what mirrors show: all of the room's light; direct light alone; or that and, to hide what "
            "is "
            "missing, the mirror lit as if it were matt (Frisvad et al. 2005, Fig. 8). What is mirrored: "
            "gi.specular.roughness.");
    list.declare<&DrmSettings::visibility>("gi.drm.visibility")
        .choices({"none", "maps"})
        .as_published(DrmVisibility::none)
        .cost("maps: four to eight times the ms while light or geometry changes, and twice the gather else")
        .docs(
            "drm: what hides a sample from what it would light, for shadows of indirect light: nothing, as "
            "in "
            "Frisvad et al. 2005, or what stands in a map of distances that is drawn about each sample, of "
            "the "
            "strongest 256: 0.4 MB each.");
    list.declare<&DrmSettings::second>("gi.drm.second")
        .unit("samples a side")
        .range(0, 4)
        .as_published(0)
        .cost("ms by 1 + the square, and the scene drawn about every sample when light or geometry changes")
        .docs(
            "drm: samples a side of a picture that each sample takes of what it lights, for a second bounce; "
            "0: "
            "one bounce, as in Frisvad et al. 2005.");
}

bool same_samples(const DrmSettings& a, const DrmSettings& b) {
    return a.samples == b.samples && a.solid_angle == b.solid_angle && a.mips == b.mips &&
           a.texels == b.texels && a.lights == b.lights && a.visibility == b.visibility &&
           a.second == b.second;
}

}  // namespace lanthorn::gi
