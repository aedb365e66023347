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
    std::vector<std::string> marks = {};     // names of those to look at; empty: all
    std::function<void()> drawn = {};        // after every picture
};

// Checks "pictures" and "light", in this order, as far as they are chosen. A picture that is equal to the
// bit is right. Of one that is not, kSeeds pictures are drawn: light and detail of its tiles must not differ
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

// Makes baselines of the marks of those names (all where it is empty), as `view` draws them, with the errors
// of light. Throws as check_pictures(), and InputError for a name that no mark has.
void make_baselines(const std::shared_ptr<const LevelFile>& level, const std::string& file,
                    const std::shared_ptr<const replay::Recording>& recording,
                    const std::vector<std::string>& marks, const MarkView& view, const std::string& reason,
                    const std::string& day);

}  // namespace lanthorn::tools
