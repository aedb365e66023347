// The project's headline figures: how far the indirect light of its scenes is off, and how it flickers.
// Ceilings only go down: one that goes up needs a reason that is worth a commit of its own.
//
// Each is the worse of two processors' figures (all that this one can, and GALLIUM_OVERRIDE_CPU_CAPS=sse4.1),
// rounded up by about a fiftieth (flux: 0.003): more than the processors differ, which is a hundredth at
// most. A figure that falls below kStale of its ceiling fails the test, too: put the new one in, so that it
// cannot be lost again.
//
// Errors are those of a first frame, by gather too; its flicker is that of frames after the sixteenth.
#pragma once

namespace lanthorn::workbench {

// Of a slow motion: how much a technique's picture changes from frame to frame, over how much the true one
// does.
struct Flicker {
    double ceiling;
    // The true picture's change as a share of its mean, of which no ceiling is made: `lanthorn measure
    // flicker SCENE --motion light|pan --size 96x96 --frames 4 --warmup 2 --spp 1024` (pan: 256; light in
    // cornell: as it is by default), its reference_change over reference_mean. Measured anew, it would take
    // most of the test's time and add its own noise.
    double truth;
};

struct Headline {
    const char* stage;   // gi.emc.final
    const char* scene;   // of assets/
    const char* camera;  // empty: the first
    double relrmse;      // of the indirect irradiance, the reference's own noise taken off
    double flux;         // distance of the flux ratio from 1
    double misses;       // 1 - hit agreement; 0: photons do not know the camera, and another line has them
    Flicker light, pan;
};

inline constexpr Headline kHeadlines[] = {
    {"splat", "cornell", "", 0.157, 0.013, 0.0131, {2.07, 0.029}, {1.40, 0.0767}},
    {"splat", "two-rooms", "", 0.171, 0.019, 0.0353, {5.05, 0.00802}, {1.30, 0.0547}},
    {"splat", "two-rooms", "dark", 0.579, 0.023, 0, {8.38, 0.0183}, {1.24, 0.3465}},
    {"splat", "clutter", "", 0.327, 0.038, 0.0551, {11.7, 0.0108}, {1.38, 0.1179}},
    {"splat", "lantern-room", "", 0.213, 0.013, 0.0322, {1.34, 0.0317}, {1.28, 0.0415}},
    {"splat", "nave", "", 0.247, 0.051, 0.111, {28.9, 0.00540}, {2.84, 0.0494}},
    {"gather", "cornell", "", 0.09, 0.016, 0, {0.777, 0.029}, {1.14, 0.0767}},
    {"gather", "two-rooms", "", 0.061, 0.0125, 0, {1.11, 0.00802}, {1.08, 0.0547}},
    {"gather", "two-rooms", "dark", 0.366, 0.034, 0, {1.33, 0.0183}, {1.09, 0.3465}},
    {"gather", "clutter", "", 0.101, 0.008, 0, {0.98, 0.0108}, {1.02, 0.1179}},
    {"gather", "lantern-room", "", 0.0827, 0.008, 0, {0.75, 0.0317}, {1.16, 0.0415}},
    {"gather", "nave", "", 0.0565, 0.0315, 0, {1.265, 0.00540}, {1.03, 0.0494}},
};

}  // namespace lanthorn::workbench
