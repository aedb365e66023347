// Where the labels of a chart's points stand, so that none covers another, a mark or what lies outside.
#pragma once

#include <string>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::tools {

struct ChartBox {
    glm::dvec2 low{0}, high{0};  // pixels, y downwards
    bool meets(const ChartBox& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
    }
};

struct ChartLabel {
    glm::dvec2 point{0};  // that it belongs to
    std::string text;
};

struct LabelPlace {
    glm::dvec2 from{0};  // the text's beginning, or its end where `before`, on its base line; from the point
    bool before = false;
};

// Beside its point where that is free, else above, below or farther off, in a few rounds in which each label
// makes way for the others; where nothing is free, what covers least. `marks`: of all points, and whatever
// else is to be seen. `all`: labels stay within. Text is taken to be of bold sans-serif, 12 pixels high.
// O(labels * (labels + marks)).
std::vector<LabelPlace> label_places(const std::vector<ChartLabel>& labels,
                                     const std::vector<ChartBox>& marks, const ChartBox& all);

// What a label covers.
ChartBox label_box(const ChartLabel& label, const LabelPlace& place);

}  // namespace lanthorn::tools
