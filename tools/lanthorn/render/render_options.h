// What `lanthorn render` is asked for on its command line, and what of it does not go together.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/core/settings.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/workbench/render_job.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/render/path_pieces.h"

namespace lanthorn::tools {

struct RenderOptions {
    std::string scene, output, technique, pose, box, size = "512x512", stats, trace, checkpoint, turntable;
    std::vector<std::string> aovs;
    SettingsChoice settings;
    std::optional<int> seed, spp, frames;
    std::optional<float> time_limit, target_noise;
    std::string play_budget;
    RenderJob job;
    PieceChoice pieces;
    bool list_settings = false, list_aovs = false, print_schedule = false;
};

// `options` is filled when the command line is read: it must live until then.
void add_render_options(CLI::App& command, RenderOptions& options);

// Later wins: preset, file, --set, the options of their own.
void configure(Settings& settings, const RenderOptions& options);
const gi::TechniqueEntry& technique_of(const Settings& settings);

// Each throws InputError. `path`: the technique is the path tracer.
void check_path_options(const RenderOptions& options, bool path);  // they need it
void check_budget(const RenderOptions& options, bool path);
// A picture of pieces has a number of samples, and what is added up needs all of them.
void check_pieces(const RenderOptions& options, const Settings& settings, bool path);
// A turntable is a file of its own, of frames.
void check_turntable_alone(const RenderOptions& options, bool path);

// What other processes are told of this one's picture.
PieceCommand piece_command(const RenderOptions& options, const Settings& settings);

// Decisions that a run before wrote with --stats. Throws InputError naming the file.
void read_budget(BudgetWish& wish, const std::string& file);

}  // namespace lanthorn::tools
