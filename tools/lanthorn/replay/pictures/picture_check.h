// Pictures and light at a recording's marks, held against their baselines.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/lanthorn/replay/pictures/light_check.h"
#include "tools/lanthorn/replay/pictures/picture_fault.h"
#include "tools/lanthorn/replay/verdict.h"

namespace lanthorn::tools {

struct PictureChoice {
    bool pictures = false;
    bool light = false;
    std::string out;                         // folder for what differs; empty: nothing is written
    std::optional<PictureFault> fault = {};  // to be found
    std::optional<int> seed = {};            // the first of those drawn with; none: the baseline's
    std::vector<std::string> marks = {};     // names of those to look at; empty: all
    std::function<void()> drawn = {};        // after every frame
};

// Checks "pictures" and "light", in this order, as far as they are chosen. A picture that is equal to the
// bit is right. Of one that is not, direct light, which has no noise, must be as it was (direct_difference).
// Then kSeeds pictures are drawn: light and detail of its tiles must not differ
// for sure from those of the same seeds before (sure_difference), and it must not look farther from the
// expected picture than those of other seeds do from it. A baseline that is missing fails, and the picture is
// written where `out` says. Throws InputError for marks and baselines that cannot be read, Error without
// OpenGL.
struct PictureResults {
    std::vector<Check> checks;
    std::vector<PictureVerdict> pictures;
};
PictureResults check_pictures(const std::shared_ptr<const LevelFile>& level, const std::string& file,
                              const std::shared_ptr<const replay::Recording>& recording,
                              const PictureChoice& choice, int threads);
// The same of marks that have been looked at.
PictureResults results_of(std::vector<PictureVerdict> pictures, const PictureChoice& choice);

// The marks of those names (all where it is empty), by step. Throws InputError for a name that none has.
std::vector<replay::Mark> chosen_marks(const std::string& file, const replay::Recording& recording,
                                       const std::vector<std::string>& names);

// Makes baselines of the marks of those names (all where it is empty), as `view` draws them, with the errors
// of light if `with_light`. Throws as check_pictures(), and InputError for a name that no mark has.
void make_baselines(const std::shared_ptr<const LevelFile>& level, const std::string& file,
                    const std::shared_ptr<const replay::Recording>& recording,
                    const std::vector<std::string>& marks, const MarkView& view, const std::string& reason,
                    const std::string& day, bool with_light = true);

}  // namespace lanthorn::tools
