#include "gi_module/techniques/coarse-path/coarse_settings.h"

#include "lanthorn/gi/setting_list.h"

namespace lanthorn::gi {

void declare_coarse_settings(SettingList& list) {
    list.declare<&CoarseSettings::grid>("gi.coarse-path.grid")
        .choices({"1", "2", "4", "8", "16"})
        .presets({Spacing::eight, Spacing::four, Spacing::four, Spacing::two})
        .cost("inverse square in ms of paths and filter")
        .docs(
            "coarse-path: pixels between the points that light is computed at; where none of them lies on a "
            "pixel's surface, a point is added.");
    list.declare<&CoarseSettings::samples>("gi.coarse-path.samples")
        .unit("paths a point a frame")
        .range(0.125f, 1024.0f)
        .presets({2.0f, 2.0f, 8.0f, 8.0f})
        .cost("linear in ms of paths")
        .docs("coarse-path: mean number; noisy and newly seen places get more.");
    list.declare<&CoarseSettings::history>("gi.coarse-path.history")
        .unit("frames")
        .range(1, 1000)
        .cost("none")
        .docs(
            "coarse-path: frames whose samples are kept while light or geometry changes. Few: noise and "
            "flicker; many: light lags behind.");
    list.declare<&CoarseSettings::still_history>("gi.coarse-path.still_history")
        .unit("frames")
        .range(1, 1000)
        .cost("once a still picture has so many, nothing more is traced")
        .docs(
            "coarse-path: the same while only the camera moves, or nothing; gi.accumulate if that is more.");
    list.declare<&CoarseSettings::filter>("gi.coarse-path.filter")
        .unit("levels")
        .range(0, 6)
        .cost("linear in ms of the filter")
        .docs("coarse-path: levels of the a-trous filter; each reaches twice as far as the last.");
    list.declare<&CoarseSettings::sigma>("gi.coarse-path.sigma")
        .unit("standard deviations")
        .range(0.1f, 1000.0f)
        .cost("none")
        .docs("coarse-path: difference in luminance that the filter averages over. Large: blur.");
    list.declare<&CoarseSettings::threads>("gi.coarse-path.threads")
        .unit("threads")
        .range(0, 1024)
        .cost("inverse in ms of paths; 0: as many as there are cores")
        .docs("coarse-path: threads that trace. Never changes the picture.");
}

}  // namespace lanthorn::gi
