// Yao et al. 2010, Table 1: what was measured there, and the scene that stands for it here.
#pragma once

#include <array>

namespace lanthorn::tools {

struct PaperRow {
    const char* scene;   // of tools/scene_generator, made after the figure
    const char* figure;  // of the paper
    const char* mover;   // the node that slides where geometry moves; null: the scene's own animation
    int triangles;       // the paper's
    int photons;         // global ones
    int caustic_photons;
    int bounces;
    int maps;
    double fps_512, fps_1024;  // the paper's, on a GeForce GTX 260
};

// Maps after sec. 8: 12 for the nave, 8 for all others.
inline constexpr std::array<PaperRow, 8> kPaperRows = {{
    {"diffuse-box", "1 (a)", "ball", 15'000, 376'000, 0, 3, 8, 22.3, 11.4},
    {"dimpled", "1 (b)", "dimpled-glass", 21'000, 91'000, 89'000, 1, 8, 13.6, 12.8},
    {"living-room", "1 (c)", "jar", 84'000, 403'000, 2'900, 3, 8, 7.2, 5.4},
    {"nave", "1 (d)", nullptr, 79'000, 739'000, 0, 2, 12, 13.3, 5.5},
    {"statues", "11 (a)", "amphora", 58'000, 464'000, 0, 1, 8, 20.8, 9.2},
    {"toys", "11 (c)", "small-ball", 101'000, 358'000, 0, 2, 8, 15.1, 7.5},
    {"ring", "11 (e)", "pawn", 2'100, 0, 164'000, 1, 8, 38.9, 28.2},
    {"pool", "10 (a)", nullptr, 54'000, 536'000, 822'000, 3, 8, 7.4, 6.3},
}};

}  // namespace lanthorn::tools
