// What bench_drm measures, and the ceilings of its errors.
#pragma once

namespace lanthorn::bench {

struct ErrorRow {
    const char* scene;    // of assets/
    const char* camera;   // "" for the first
    const char* options;  // settings, separated by spaces
    int bounces;          // of the reference
    double relrmse,
        flux;  // ceilings, which only go down: of the error, and of the flux ratio's distance from 1
};

inline constexpr ErrorRow kSampleRows[] = {
    {"cornell", "", "gi.drm.solid_angle=14 gi.drm.samples=2", 1, 0.689, 0.449},
    {"cornell", "", "gi.drm.solid_angle=14 gi.drm.samples=3", 1, 0.542, 0.243},
    {"cornell", "", "gi.drm.solid_angle=14 gi.drm.samples=4", 1, 0.486, 0.222},
    {"cornell", "", "gi.drm.solid_angle=14 gi.drm.samples=5", 1, 0.45, 0.13},
    {"cornell", "", "gi.drm.solid_angle=14 gi.drm.samples=8", 1, 0.352, 0.057},
    {"cornell", "", "gi.drm.solid_angle=14 gi.drm.samples=16", 1, 0.296, 0.04},
    {"cornell", "", "gi.drm.solid_angle=disc gi.drm.samples=3", 1, 0.54, 0.026},
    {"cornell", "", "gi.drm.solid_angle=15 gi.drm.samples=3", 1, 0.999, 0.66},
    {"cornell", "", "gi.drm.solid_angle=11 gi.drm.samples=3", 1, 2.84, 2.34},
    {"cornell", "", "gi.drm.solid_angle=14 gi.drm.mips=light", 1, 0.74, 0.495},
    {"cornell", "", "gi.drm.solid_angle=14 gi.drm.mips=radiance", 1, 0.594, 0.252},
    {"cornell", "", "gi.drm.solid_angle=14 gi.drm.mips=none", 1, 0.74, 0.52},
    {"two-rooms", "", "gi.drm.solid_angle=14 gi.drm.samples=2", 1, 0.366, 0.286},
    {"two-rooms", "", "gi.drm.solid_angle=14 gi.drm.samples=3", 1, 0.31, 0.196},
    {"two-rooms", "", "gi.drm.solid_angle=14 gi.drm.samples=4", 1, 0.26, 0.145},
    {"two-rooms", "", "gi.drm.solid_angle=14 gi.drm.samples=5", 1, 0.241, 0.117},
    {"two-rooms", "", "gi.drm.solid_angle=14 gi.drm.samples=8", 1, 0.204, 0.054},
    {"two-rooms", "", "gi.drm.solid_angle=14 gi.drm.samples=16", 1, 0.183, 0.01},
};

inline constexpr ErrorRow kNearRows[] = {
    {"near-lamp", "", "gi.drm.solid_angle=11", 1, 41.3, 31.5},
    {"near-lamp", "", "gi.drm.solid_angle=13", 1, 0.487, 0.06},
    {"near-lamp", "", "gi.drm.solid_angle=15", 1, 0.86, 0.66},
    {"near-lamp", "", "gi.drm.solid_angle=14", 1, 0.472, 0.275},
    {"near-lamp", "", "gi.drm.solid_angle=disc", 1, 0.428, 0.107},
};

inline constexpr ErrorRow kBeyondRows[] = {
    {"cornell", "", "gi.drm.samples=5", 1, 0.459, 0.03},
    {"cornell", "", "gi.drm.samples=5 gi.drm.visibility=maps", 1, 0.462, 0.185},
    {"lantern-room-open", "dark", "gi.drm.samples=5", 2, 2.63, 0.68},
    {"lantern-room-open", "dark", "gi.drm.samples=5 gi.drm.visibility=maps", 2, 1.68, 0.56},
    {"lantern-room-open", "dark", "gi.drm.samples=5 gi.drm.visibility=maps gi.drm.second=1", 2, 0.98, 0.32},
    {"lantern-room-open", "dark", "gi.drm.samples=5 gi.drm.visibility=maps gi.drm.second=2", 2, 0.915, 0.24},
    {"corridor", "", "gi.drm.samples=5", 2, 2.2, 0.14},
    {"corridor", "", "gi.drm.samples=5 gi.drm.visibility=maps", 2, 1.94, 0.695},
    {"corridor", "", "gi.drm.samples=5 gi.drm.visibility=maps gi.drm.second=1", 2, 1.49, 0.565},
    {"corridor", "", "gi.drm.samples=5 gi.drm.visibility=maps gi.drm.second=2", 2, 1.28, 0.48},
    {"cornell", "", "gi.drm.samples=5", 2, 0.519, 0.32},
    {"cornell", "", "gi.drm.samples=5 gi.drm.visibility=maps", 2, 0.622, 0.455},
    {"cornell", "", "gi.drm.samples=5 gi.drm.visibility=maps gi.drm.second=1", 2, 0.506, 0.286},
    {"cornell", "", "gi.drm.samples=5 gi.drm.visibility=maps gi.drm.second=2", 2, 0.43, 0.226},
};

// Frisvad et al. 2005, Table 1, and sec. 6 for what it has not.
struct SpeedRow {
    const char* scene;  // of assets/, or dragon_sized
    const char* figure;
    const char* part;
    const char* options;
    double fps;  // the paper's; 0: it has none
    bool first;  // direct light alone, which the figure's others are held against
};

inline constexpr SpeedRow kSpeedRows[] = {
    {"cornell", "3", "direct", "gi.technique=none", 137.3, true},
    {"cornell", "4 (a)", "eq. 11", "gi.drm.solid_angle=11", 48.622, false},
    {"cornell", "4 (b)", "eq. 15", "gi.drm.solid_angle=15", 48.622, false},
    {"cornell", "4 (c)", "eq. 14", "gi.drm.solid_angle=14", 20.87, false},
    {"cornell", "", "disc, M = 3", "gi.drm.solid_angle=disc", 0, false},
    {"cornell", "", "the same, hidden", "gi.drm.visibility=maps", 0, false},
    {"cornell", "", "the same, two bounces", "gi.drm.visibility=maps gi.drm.second=1", 0, false},
    {"mirror-balls", "8", "direct", "gi.technique=none", 0, true},
    {"mirror-balls", "8 (a)", "mirrors show direct light", "gi.drm.solid_angle=14 gi.drm.mirrors=direct",
     15.178, false},
    {"mirror-balls", "8 (b)", "and are lit as if matt", "gi.drm.solid_angle=14 gi.drm.mirrors=trick", 15.178,
     false},
    {"mirror-balls", "8 (c)", "mirrors show all", "gi.drm.solid_angle=14", 9.898, false},
    {"cave", "9 (a)", "direct, no mirrors", "gi.technique=none", 48.0, true},
    {"cave", "9 (b)", "eq. 15, no mirrors", "gi.drm.solid_angle=15 gi.specular.roughness=0", 18.4, false},
    {"cave", "9 (c)", "eq. 14, no mirrors", "gi.drm.solid_angle=14 gi.specular.roughness=0", 10.3, false},
    {"cave", "9 (b)", "eq. 15", "gi.drm.solid_angle=15 gi.drm.mirrors=trick", 11.888, false},
    {"cave", "9 (c)", "eq. 14", "gi.drm.solid_angle=14 gi.drm.mirrors=trick", 7.695, false},
    {"dragon_sized", "sec. 6", "direct", "gi.technique=none", 0, true},
    {"dragon_sized", "sec. 6", "eq. 15", "gi.drm.solid_angle=15", 1.8, false},
    {"dragon_sized", "sec. 6", "eq. 14", "gi.drm.solid_angle=14", 0.92, false},
};

}  // namespace lanthorn::bench
