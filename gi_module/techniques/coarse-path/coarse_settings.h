// What can be set of `coarse-path`: gi.coarse-path.*, declared with unit, range and cost in
// coarse_settings.cpp.
#pragma once

namespace lanthorn::gi {

class SettingList;

enum class Spacing { one, two, four, eight, sixteen };  // 1 << value: full-size pixels

struct CoarseSettings {
    Spacing grid = Spacing::four;  // of the points that light is computed at
    float samples = 2;             // paths a point a frame, on average
    int history = 8;               // frames' samples that are kept while light or geometry changes
    int still_history = 32;        // the same while neither does
    int filter = 4;                // levels of the a-trous filter
    float sigma = 4;               // of its luminance, in standard deviations
    int threads = 0;               // 0: all; never changes the image
};

void declare_coarse_settings(SettingList& list);

}  // namespace lanthorn::gi
