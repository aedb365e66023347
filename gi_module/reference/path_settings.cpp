#include "lanthorn/reference/path_settings.h"

#include "lanthorn/core/settings.h"

namespace lanthorn::reference {

namespace {

// `value` stays where a program without the technique `path` has not declared the setting.
template <class T>
void read(const Settings& s, const char* name, T& value) {
    if (s.schema().find(name) != nullptr) {
        value = s.get<T>(name);
    }
}

}  // namespace

PathSettings path_settings(const Settings& s) {
    PathSettings p;
    read(s, "path.spp", p.spp);
    read(s, "path.frame_spp", p.frame_spp);
    read(s, "path.time_limit", p.time_limit);
    read(s, "path.target_noise", p.target_noise);
    read(s, "path.transport", p.transport);
    read(s, "path.caustics", p.caustics);
    read(s, "path.unlimited", p.unlimited);
    read(s, "path.antialias", p.antialias);
    read(s, "path.threads", p.threads);
    p.bounces = s.get<int>("gi.bounces");
    // The same light as the final gather's by default; bounces that somebody has asked for are counted.
    bool endless = false;
    read(s, "gi.gather.endless", endless);
    p.unlimited |= p.transport == Transport::automatic && endless && s.is_default("gi.bounces");
    p.seed = static_cast<std::uint32_t>(s.get<int>("gi.seed"));
    if ((p.time_limit > 0 || p.target_noise > 0) && s.is_default("path.spp")) {
        p.spp = kMostSamples;
    }
    return p;
}

PathSettings settled(PathSettings settings, bool picture) {
    if (settings.transport == Transport::automatic) {
        settings.transport = picture ? Transport::full : Transport::diffuse;
        settings.unlimited = settings.unlimited || picture;
    }
    return settings;
}

std::string transport_name(Transport transport) {
    return transport == Transport::diffuse ? "diffuse" : transport == Transport::full ? "full" : "automatic";
}

}  // namespace lanthorn::reference
