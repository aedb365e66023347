#include "lanthorn/reference/path_settings.h"

#include "lanthorn/core/settings.h"

namespace lanthorn::reference {

PathSettings path_settings(const Settings& s) {
    PathSettings p;
    p.spp = s.get<int>("path.spp");
    p.frame_spp = s.get<int>("path.frame_spp");
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
