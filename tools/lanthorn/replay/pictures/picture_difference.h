// How far a picture looks from an expected one: on the whole, and in the place where it is worst.
#pragma once

#include <string>

#include "lanthorn/core/image.h"

namespace lanthorn::tools {

struct PictureDifference {
    double flip = 0;               // mean LDR-FLIP, 0 to 1
    double worst_tile = 0;         // the largest mean of a tile of kTilePixels (picture_figures.h)
    int worst_x = 0, worst_y = 0;  // which, in tiles

    // The larger of each.
    PictureDifference& widen(const PictureDifference& other);
    // Names what is beyond the noise floor of pictures that differ by their seeds alone: times 1.5, and half
    // a step of 8 bits. Empty: nothing.
    std::string beyond(const PictureDifference& floor) const;
};

// Display-encoded pictures; of other sizes throws InputError that names `what`.
PictureDifference picture_difference(const ImageF& shown, const ImageF& expected, const std::string& what);

// "FLIP 0.081, worst tile (12, 7) 0.340".
std::string difference_words(const PictureDifference& difference);

// Whether two display-encoded pictures of one size are equal as 8 bits a channel hold them.
bool equal_in_8_bits(const ImageF& a, const ImageF& b);

}  // namespace lanthorn::tools
