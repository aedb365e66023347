// Where the labels of the picture go, so that each can be read.
#pragma once

#include <optional>
#include <span>

namespace lanthorn::ui {

// A label of one line: its left end, the middle of its height, its width; pixels.
struct LabelPlace {
    float x = 0, y = 0, width = 0;
};

// The height in low..high nearest to the wanted one at which a label that is `line` high covers none of
// `placed`. Nothing if there is no room. `low` <= `high`. Cost: the square of the labels placed.
std::optional<float> free_height(std::span<const LabelPlace> placed, const LabelPlace& wanted, float line,
                                 float low, float high);

}  // namespace lanthorn::ui
