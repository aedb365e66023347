// Figures of a picture's tiles, and whether those of two builds differ for sure: paired by seed, so that the
// noise of drawing is in common where the builds draw alike, and is known where they do not.
#pragma once

#include <string>
#include <vector>

#include "lanthorn/core/image.h"

namespace lanthorn::tools {

inline constexpr int kTilePixels = 32;
// Pictures of a mark, of seeds that follow each other. The p-value below is that of five.
inline constexpr int kSeeds = 5;

// Of one picture, row by row from the top; tiles of kTilePixels a side, those at the right and bottom edges
// smaller.
struct PictureFigures {
    int columns = 0;
    std::vector<double> light;   // mean luminance, nits
    std::vector<double> detail;  // mean step of the shown luminance from a pixel to the next, 0 to 1

    double mean_light() const;  // tiles taken as equal
};
// `shown`: display-encoded; `radiance`: nits; of one size, 3 channels.
PictureFigures picture_figures(const ImageF& shown, const ImageF& radiance);

// How one figure of one tile differs.
struct FigureDifference {
    std::string figure;  // "light", "detail" or "direct light"; empty: of none for sure
    int x = 0, y = 0;    // the tile; -1: of the whole picture
    double change = 0;   // now over before, minus 1
    double p = 1;        // of Student's paired test, times the number of tests (Bonferroni); 0: no noise
};
// The largest change of those that are sure (p below 1 %) and matter (more than half a percent). `before` and
// `now`: kSeeds of equal tiles each; else throws InputError that names `what`.
FigureDifference sure_difference(const std::vector<PictureFigures>& before,
                                 const std::vector<PictureFigures>& now, const std::string& what);

// Mean luminance of direct light by tile, nits.
std::vector<double> light_of_tiles(const ImageF& radiance);
// The largest change of a tile's direct light, which has no noise. More than kDirectLight of what it was is
// too much. Throws as sure_difference().
inline constexpr double kDirectLight = 0.006;
FigureDifference direct_difference(const std::vector<double>& before, const std::vector<double>& now,
                                   int columns, const std::string& what);

// The two-sided p-value of Student's t with 4 degrees of freedom.
double student_p4(double t);

}  // namespace lanthorn::tools
