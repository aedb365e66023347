// Faults of light and picture, to see whether comparisons find them.
#pragma once

#include <string>
#include <string_view>

#include "tools/lanthorn/replay/pictures/fault_targets.h"

namespace lanthorn::tools {

enum class PictureFault {
    lamp,      // the lamp that lights most of the picture is 1 % brighter
    off,       // it is off
    moved,     // it is 10 cm higher
    shadow,    // the mover with the largest shadow has none
    indirect,  // there is no indirect light
    nan,       // one pixel is no number
    half,      // half the resolution
    black,     // nothing is drawn
    tenth,     // all lamps are 10 % brighter
};
inline constexpr std::string_view kPictureFaults[] = {"lamp", "off",  "moved", "shadow", "indirect",
                                                      "nan",  "half", "black", "tenth"};

// Throws InputError, with the words there are, for another.
PictureFault parse_picture_fault(std::string_view text);

// "lantern.flame is 1 % brighter". Empty where there is nothing of the kind to alter.
std::string fault_words(PictureFault fault, const FaultTargets& targets);

// Of the world, before it is drawn; nothing for a fault of the picture alone.
void make_fault(PictureFault fault, const FaultTargets& targets, App& app);

// A picture with the fault, the targets being those of its mark. The picture of `shadow` is put together of
// two: where the mover is not seen, of one without it, exposed alike.
MarkPicture draw_with_fault(const MarkArtist& artist, const MarkedMoment& at, const MarkView& view,
                            PictureFault fault, const FaultTargets& targets);

}  // namespace lanthorn::tools
