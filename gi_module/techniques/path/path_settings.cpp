// What can be set of `path`, with unit, range and cost.
#include "lanthorn/reference/path_settings.h"

#include "gi_module/techniques/path/path.h"
#include "lanthorn/gi/setting_list.h"

namespace lanthorn::gi {

using reference::PathSettings;

void declare_path_settings(SettingList& list) {
    list.declare<&PathSettings::spp>("path.spp")
        .unit("samples a pixel")
        .range(1, reference::kMostSamples)
        .cost("linear in time; noise falls with its square root or faster")
        .docs("Samples a pixel at most. The same number gives the same image, however it was reached.");
    list.declare<&PathSettings::frame_spp>("path.frame_spp")
        .unit("samples a pixel")
        .range(1, 4096)
        .cost("linear in the time of a frame, until path.spp are taken")
        .docs(
            "Samples a pixel that each frame of a window adds while nothing changes. The picture depends on "
            "their sum alone. lanthorn render takes all of path.spp at once.");
    list.declare<&PathSettings::time_limit>("path.time_limit")
        .unit("s")
        .range(0.0f, 1e6f)
        .cost("none")
        .docs(
            "lanthorn render: stop after that time, with at least one sample a pixel; 0: no limit. Frames of "
            "a window have none.");
    list.declare<&PathSettings::target_noise>("path.target_noise")
        .range(0.0f, 1.0f)
        .cost("inverse square in time")
        .docs(
            "Stop once the image's own noise, relative to its mean, is estimated to be below this; 0: "
            "never.");
    list.declare<&PathSettings::transport>("path.transport")
        .choices({"diffuse", "full", "automatic"})
        .cost("full: about twice the time and more noise")
        .docs(
            "full: all that materials say: GGX, transmission, alpha and volumes of glass; diffuse: indirect "
            "light by diffuse reflections alone, which techniques' irradiance is measured against; "
            "automatic: "
            "full and of all bounces in a picture, diffuse where irradiance alone is asked for, of all "
            "bounces there unless gi.bounces or gi.gather.endless says otherwise.");
    list.declare<&PathSettings::caustics>("path.caustics")
        .cost("none")
        .docs(
            "Of full transport: whether light that smooth metal has mirrored, or that has gone through "
            "glass, is in the direct and indirect images.");
    list.declare<&PathSettings::unlimited>("path.unlimited")
        .cost("grows with the scene's albedo")
        .docs("Follow light until Russian roulette ends it instead of for gi.bounces reflections.");
    list.declare<&PathSettings::antialias>("path.antialias")
        .cost("a camera ray more a sample")
        .docs("Spread samples over the pixel; off, they go through its centre as the rasteriser's do.");
    list.declare<&PathSettings::threads>("path.threads")
        .unit("threads")
        .range(0, 1024)
        .cost("inverse in time up to the number of cores")
        .docs(
            "Threads that trace, no more than there are cores; 0: as many. The image does not depend on it.");
}

}  // namespace lanthorn::gi
