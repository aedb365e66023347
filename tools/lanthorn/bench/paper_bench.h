// Frames of the paper's scenes with the paper's counts, measured.
#pragma once

#include <map>
#include <string>

#include "lanthorn/core/settings.h"
#include "lanthorn/scene/scene_data.h"
#include "tools/lanthorn/bench/paper_rows.h"

namespace lanthorn::tools {

struct PaperJob {
    ivec2 size{512, 512};
    int frames = 8;  // measured
    int warmup = 3;  // before
    // Geometry moves too: `mover`, a node's name, slides to and fro by 2 cm a frame (null: nothing does), and
    // what is animated goes on by 1/30 s.
    bool moving = false;
    const char* mover = nullptr;
};

struct PaperFigures {
    double frame = 0, gi = 0;              // milliseconds, medians
    double frame_cpu = 0, gi_cpu = 0;      // of processor time, all threads
    std::map<std::string, double> passes;  // of indirect light, each without those within it
    std::uint64_t photons = 0;             // emitted in a frame, as the technique counts them
    std::uint64_t nan_count = 0;
    std::string renderer;

    double fps() const { return 1000 / frame; }
    // Without indirect light, of processor time.
    double direct_cpu() const { return frame_cpu - gi_cpu; }
};

// The scene of a row. There is one for each.
SceneData paper_scene(const PaperRow& row);
// That many, and at least one where there are any.
int paper_share(int photons, double share);
// Photons, bounces and maps of a row, in `settings`.
void apply_row(const PaperRow& row, double share, Settings& settings);

// Frames in which all lamps change by their last bit, so that every photon is traced in each of them.
// Throws Error(ExitCode::no_gl) without OpenGL 4.5.
PaperFigures measure_row(const SceneData& scene, const Settings& settings, const PaperJob& job);

}  // namespace lanthorn::tools
