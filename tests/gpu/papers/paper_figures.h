// Errors of the four papers' techniques as published (--preset paper), 96x96 pixels, the first frame. Each is
// a ceiling, which only goes down; a figure below kStalePaper of its ceiling fails the test, too: lower the
// ceiling. No figure depends on the clock.
#pragma once

namespace lanthorn::workbench {

struct PaperFigure {
    const char* technique;
    const char* scene;  // of assets/
    double relrmse;  // of the indirect irradiance by one technique's own bounces; the reference's noise taken
                     // off
    double flux;     // distance of the flux ratio from 1
    double misses;   // 1 - the share of photons' image-space hits that exact rays agree with; 0: not asked
    double unseen;   // share of the lit surface that no map sees; where misses are asked
};

// Yao et al. 2010: the false position of sec. 5.1 loses light in corners; the nave is the paper's own kind of
// scene. Frisvad et al. 2005: M = 3, eq. 14, one bounce, of one lamp, against three. Jozwowski 2002: 2000
// photons, 100 a frame, direct light among them; Lavignotte and Paulin 2003: what 376 000 walks show at once.
inline constexpr PaperFigure kPaperFigures[] = {
    {"emc", "cornell", 0.277, 0.159, 0.191, 0.001},
    {"emc", "nave", 0.230, 0.037, 0.200, 0.012},
    {"drm", "cornell", 0.749, 0.566, 0, 0},
    {"drm", "mirror-balls", 0.866, 0.694, 0, 0},
    {"vertex-map", "cornell", 0.328, 0.016, 0, 0},
    {"splat", "cornell", 0.084, 0.009, 0, 0},
    {"splat", "ring", 0.678, 0.1, 0, 0},
};

inline constexpr double kStalePaper = 0.85;

}  // namespace lanthorn::workbench
