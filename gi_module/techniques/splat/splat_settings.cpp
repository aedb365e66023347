#include "gi_module/techniques/splat/splat_settings.h"

#include "lanthorn/gi/setting_list.h"

namespace lanthorn::gi {

void declare_splat_settings(SettingList& list) {
    list.declare<&SplatSettings::photons>("gi.splat.photons")
        .unit("walks of light")
        .range(0, 1'000'000'000)
        .presets({100'000, 1'000'000, 3'000'000, 10'000'000})
        .as_published(1'000'000)
        .cost("linear in ms of tracing until a still picture has so many; none afterwards")
        .docs(
            "splat: walks that a still picture grows to, from gi.photons at once. gi.photons if that is "
            "more.");
    list.declare<&SplatSettings::batch>("gi.splat.batch")
        .unit("walks of light a frame")
        .range(1, 10'000'000)
        .cost("linear in ms of a frame while a still picture grows")
        .docs("splat: how fast it grows; at most doubled from one frame to the next.");
    list.declare<&SplatSettings::bandwidth>("gi.splat.bandwidth")
        .unit("square root of a photon's area")
        .range(0.5f, 1000.0f)
        .presets({12.0f, 20.0f, 20.0f, 20.0f})
        .as_published(20)
        .cost("square in ms of the splats")
        .docs("splat: C of h = C sqrt(A / N): pi C^2 photons are averaged. Small: noise; large: blur.");
    list.declare<&SplatSettings::caustic_bandwidth>("gi.splat.caustic_bandwidth")
        .unit("square root of a photon's area")
        .range(0.05f, 1000.0f)
        .as_published(2)
        .cost("square in ms of the caustic splats")
        .docs("splat: the same of light that has met mirrors and glass alone.");
    list.declare<&SplatSettings::kernel>("gi.splat.kernel")
        .choices({"constant", "epanechnikov"})
        .as_published(PhotonKernel::constant)
        .cost("epanechnikov: a fifth more")
        .docs("splat: how a photon's light falls off over its splat.");
    list.declare<&SplatSettings::boundaries>("gi.splat.boundaries")
        .as_published(true)
        .cost("half a microsecond a pixel when the view or the photons change")
        .docs("splat: divide by the area of surface within the kernel, not by the whole kernel's.");
    list.declare<&SplatSettings::adaptive>("gi.splat.adaptive")
        .choices({"none", "caustics", "all"})
        .as_published(SplatAdaptive::all)
        .cost("a second and third round of splats where light changes fast")
        .docs("splat: for which photons smaller bandwidths are tried where that lowers the error.");
    list.declare<&SplatSettings::levels>("gi.splat.levels")
        .unit("bandwidths")
        .range(1, 12)
        .as_published(4)
        .cost("linear in ms where the first are refused")
        .docs("splat: how many are tried, each three quarters of the one before.");
    list.declare<&SplatSettings::least>("gi.splat.least")
        .unit("photons")
        .range(0, 1'000'000)
        .cost("less than none")
        .docs("splat: N_min: where fewer are averaged, a smaller bandwidth would be too noisy.");
    list.declare<&SplatSettings::most>("gi.splat.most")
        .unit("photons")
        .range(0, 1'000'000)
        .cost("less than none")
        .docs("splat: N_max: where more are averaged, a smaller bandwidth is always tried.");
    list.declare<&SplatSettings::bias>("gi.splat.bias")
        .range(0.0f, 1e6f)
        .cost("less than none")
        .docs(
            "splat: epsilon: between N_min and N_max a smaller bandwidth is tried where the second "
            "difference of "
            "the number of photons over half a bandwidth is more than this share of it.");
    list.declare<&SplatSettings::scattering>("gi.splat.scattering")
        .choices({"even", "full"})
        .as_published(PhotonScattering::full)
        .cost("full: half as many rays a second")
        .docs(
            "splat: what light does at surfaces that are neither mirrors nor glass: scattered evenly by what "
            "they reflect, or by the whole BSDF.");
    list.declare<&SplatSettings::memory>("gi.splat.memory")
        .unit("MiB")
        .range(32, 1 << 20)
        .as_published(64)
        .cost("none; photons beyond it are read from disk again for each view")
        .docs("splat: memory for photons; more of them are kept in a temporary file.");
    list.declare<&SplatSettings::threads>("gi.splat.threads")
        .unit("threads")
        .range(0, 1024)
        .cost("inverse in ms of tracing; 0: as many as there are cores")
        .docs("splat: threads that trace. Never changes the picture.");
}

}  // namespace lanthorn::gi
