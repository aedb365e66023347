// What the four papers' techniques come to as they were published (--preset paper), 96x96 pixels, the first
// frame. Ceilings only go down; a figure below kStalePaper of its ceiling fails the test, too: put the new
// one in. No figure depends on the clock.
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

// Yao et al. 2010: the false position of sec. 5.1 loses light; the nave is the paper's own kind of scene.
// Frisvad et al. 2005: M = 3, eq. 14, one bounce of the three. Jozwowski 2002: 2000 photons, 100 a frame;
// Lavignotte and Paulin 2003: what 376 000 walks show at once.
inline constexpr PaperFigure kPaperFigures[] = {
    {"emc", "cornell", 1, 1, 1, 1},        {"emc", "nave", 1, 1, 1, 1},
    {"drm", "cornell", 1, 1, 0, 0},        {"drm", "mirror-balls", 1, 1, 0, 0},
    {"vertex-map", "cornell", 1, 1, 0, 0}, {"splat", "cornell", 1, 1, 0, 0},
    {"splat", "ring", 1, 1, 0, 0},
};

inline constexpr double kStalePaper = 0.85;

}  // namespace lanthorn::workbench
