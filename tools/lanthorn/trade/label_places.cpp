#include "tools/lanthorn/trade/label_places.h"

#include <limits>

namespace lanthorn::tools {

namespace {

constexpr double kCharacter = 8.0, kAbove = 10, kBelow = 3;  // pixels, of the text
constexpr int kRounds = 4;                                   // in which each makes way for the others

// From best to worst.
constexpr LabelPlace kPlaces[] = {
    {{9, -6}, false},    {{9, 14}, false},  {{10, 4}, false},  {{-9, -6}, true},    {{-9, 14}, true},
    {{-10, 4}, true},    {{6, -18}, false}, {{6, 26}, false},  {{-6, -18}, true},   {{-6, 26}, true},
    {{4, -30}, false},   {{4, 38}, false},  {{-4, -30}, true}, {{-4, 38}, true},    {{4, -42}, false},
    {{4, 50}, false},    {{-4, -42}, true}, {{-4, 50}, true},  {{-40, -12}, false}, {{-40, 20}, false},
    {{-70, -12}, false}, {{-70, 20}, false}};

double shared(const ChartBox& a, const ChartBox& b) {
    const glm::dvec2 size = glm::max(glm::min(a.high, b.high) - glm::max(a.low, b.low), glm::dvec2(0));
    return size.x * size.y;
}

}  // namespace

ChartBox label_box(const ChartLabel& label, const LabelPlace& place) {
    const double width = kCharacter * static_cast<double>(label.text.size());
    const glm::dvec2 at = label.point + place.from;
    const double left = place.before ? at.x - width : at.x;
    return {{left, at.y - kAbove}, {left + width, at.y + kBelow}};
}

std::vector<LabelPlace> label_places(const std::vector<ChartLabel>& labels,
                                     const std::vector<ChartBox>& marks, const ChartBox& all) {
    std::vector<LabelPlace> result(labels.size(), kPlaces[0]);
    std::vector<ChartBox> boxes;  // of those that have a place
    const auto covered = [&](std::size_t label, const ChartBox& box) {
        const glm::dvec2 size = box.high - box.low;
        double area = size.x * size.y - shared(box, all);
        for (const ChartBox& mark : marks) {
            area += shared(box, mark);
        }
        for (std::size_t other = 0; other < boxes.size(); ++other) {
            area += other == label ? 0 : shared(box, boxes[other]);
        }
        return area;
    };
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t i = 0; i < labels.size(); ++i) {
            double least = std::numeric_limits<double>::infinity();
            ChartBox chosen;
            for (const LabelPlace& place : kPlaces) {
                const ChartBox box = label_box(labels[i], place);
                const double area = covered(i, box);
                if (area < least) {
                    least = area;
                    chosen = box;
                    result[i] = place;
                }
            }
            if (round == 0) {
                boxes.push_back(chosen);
            }
            boxes[i] = chosen;
        }
    }
    return result;
}

}  // namespace lanthorn::tools
