#include "lanthorn/reference/path_settings.h"

#include "lanthorn/core/settings.h"

namespace lanthorn::reference {

namespace {
constexpr int kMostSamples = 1'000'000;
}

void declare_path_settings(SettingsSchema& schema) {
    const PathSettings d;
    schema.declare<int>("path.spp")
        .unit("samples a pixel")
        .range(1, kMostSamples)
        .initially(d.spp)
        .cost("linear in time; noise falls with its square root or faster")
        .docs("Samples a pixel at most. The same number gives the same image, however it was reached.");
    schema.declare<float>("path.time_limit")
        .unit("s")
        .range(0.0f, 1e6f)
        .initially(d.time_limit)
        .cost("none")
        .docs("Stop after that time, with at least one sample a pixel; 0: no limit.");
    schema.declare<float>("path.target_noise")
        .range(0.0f, 1.0f)
        .initially(d.target_noise)
        .cost("inverse square in time")
        .docs(
            "Stop once the image's own noise, relative to its mean, is estimated to be below this; 0: "
            "never.");
    schema.declare<Transport>("path.transport")
        .choices({"diffuse", "full"})
        .initially(d.transport)
        .cost("full: about twice the time and more noise")
        .docs(
            "diffuse: indirect light by diffuse reflections alone, what emc estimates; full: GGX, "
            "transmission, "
            "alpha and volumes of glass too.");
    schema.declare<bool>("path.caustics")
        .initially(d.caustics)
        .cost("none")
        .docs(
            "Of path.transport=full: whether light that smooth metal has mirrored, or that has gone through "
            "glass, is in the direct and indirect images.");
    schema.declare<bool>("path.unlimited")
        .initially(d.unlimited)
        .cost("grows with the scene's albedo")
        .docs("Follow light until Russian roulette ends it instead of for gi.bounces reflections.");
    schema.declare<bool>("path.antialias")
        .initially(d.antialias)
        .cost("a camera ray more a sample")
        .docs("Spread samples over the pixel; off, they go through its centre as the rasteriser's do.");
    schema.declare<int>("path.threads")
        .unit("threads")
        .range(0, 1024)
        .initially(d.threads)
        .cost("inverse in time up to the number of cores")
        .docs(
            "Threads that trace, no more than there are cores; 0: as many. The image does not depend on it.");
}

PathSettings path_settings(const Settings& s) {
    PathSettings p;
    p.spp = s.get<int>("path.spp");
    p.time_limit = s.get<float>("path.time_limit");
    p.target_noise = s.get<float>("path.target_noise");
    p.transport = s.get<Transport>("path.transport");
    p.caustics = s.get<bool>("path.caustics");
    p.unlimited = s.get<bool>("path.unlimited");
    p.antialias = s.get<bool>("path.antialias");
    p.threads = s.get<int>("path.threads");
    p.bounces = s.get<int>("gi.bounces");
    p.seed = static_cast<std::uint32_t>(s.get<int>("gi.seed"));
    if ((p.time_limit > 0 || p.target_noise > 0) && s.is_default("path.spp")) {
        p.spp = kMostSamples;
    }
    return p;
}

std::string transport_name(Transport transport) {
    return transport == Transport::diffuse ? "diffuse" : "full";
}

}  // namespace lanthorn::reference
