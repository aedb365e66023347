// What a mark is expected to look like: a picture and its figures, beside the recordings:
// pictures/RECORDING/MARK.png and MARK.json.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/lanthorn/replay/pictures/drawn_mark.h"
#include "tools/lanthorn/replay/pictures/picture_figures.h"

namespace lanthorn::tools {

// The error of indirect light against the path tracer, of one seed.
struct LightError {
    double relrmse = 0;  // noise of the reference taken off
    double flux = 0;     // mean over the reference's
};

struct Baseline {
    MarkView view;
    ImageF shown;  // of MarkView::seed
    // By seed, from MarkView::seed on, kSeeds of them.
    std::vector<PictureFigures> figures;
    std::vector<double> direct;  // light_of_tiles() of direct light alone
    // By seed, from MarkView::seed on, of kLightSize (light_check.h); empty: not measured.
    std::vector<LightError> errors;
    std::string build, reason, day;  // that made it, why it is as it is, "2026-12-31"
};

// The PNG; the JSON lies beside it. Throws InputError for a mark whose name is no file's.
std::filesystem::path baseline_file(const std::filesystem::path& recording, const std::string& mark);

// Nothing where neither file is there. Throws InputError for files that are damaged, or one alone.
std::optional<Baseline> read_baseline(const std::filesystem::path& recording, const std::string& mark);

// Makes the folders. Throws InputError where they cannot be written.
void write_baseline(const std::filesystem::path& recording, const std::string& mark,
                    const Baseline& baseline);

}  // namespace lanthorn::tools
