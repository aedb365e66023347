// Faults of light and picture, to see whether comparisons find them: of the world before it is drawn, or of
// the picture.
#pragma once

#include <string>
#include <string_view>

#include "tools/lanthorn/replay/pictures/drawn_mark.h"

namespace lanthorn::tools {

enum class PictureFault {
    lamp,      // the brightest lamp is 1 % brighter
    off,       // it is off
    moved,     // it is 10 cm higher
    indirect,  // there is no indirect light
    nan,       // one pixel is no number
    half,      // half the resolution
    black,     // nothing is drawn
};
inline constexpr std::string_view kPictureFaults[] = {"lamp", "off",  "moved", "indirect",
                                                      "nan",  "half", "black"};

// Throws InputError, with the words there are, for another.
PictureFault parse_picture_fault(std::string_view text);

// Of the world. Returns whether there was anything to alter.
bool make_fault(PictureFault fault, App& app);
// Of the picture.
void make_fault(PictureFault fault, MarkPicture& picture);

}  // namespace lanthorn::tools
