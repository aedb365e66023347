#include "tools/scene_generator/furniture.h"

namespace lanthorn::scene_generator {

Shape whole(const std::vector<Part>& parts) {
    Shape shape;
    for (const Part& part : parts) {
        add_box(shape, part.low, part.high);
    }
    return shape;
}

std::vector<Part> shelf_parts(const dvec3& size, int levels, std::vector<double>* heights) {
    constexpr double kBoard = 0.02;  // metres thick
    const dvec3 low(-0.5 * size.x, 0, 0), high = low + size;
    std::vector<Part> parts = {
        {"left", low, {low.x + kBoard, high.y, high.z}},
        {"right", {high.x - kBoard, low.y, low.z}, high},
        {"back", {low.x + kBoard, low.y, low.z}, {high.x - kBoard, high.y, low.z + kBoard}}};
    for (int i = 0; i <= levels; ++i) {
        const double y = (size.y - kBoard) * i / levels;
        parts.push_back({"board-" + std::to_string(i),
                         {low.x + kBoard, y, low.z + kBoard},
                         {high.x - kBoard, y + kBoard, high.z}});
        if (heights != nullptr && i < levels) {
            heights->push_back(y + kBoard);
        }
    }
    return parts;
}

std::vector<Part> chair_parts() {
    constexpr double kLeg = 0.03, kHalf = 0.21, kSeat = 0.45, kBack = 0.9;
    std::vector<Part> parts;
    int leg = 0;
    for (const double x : {-kHalf, kHalf - kLeg}) {
        for (const double z : {-kHalf, kHalf - kLeg}) {
            parts.push_back({"leg-" + std::to_string(++leg), {x, 0, z}, {x + kLeg, kSeat, z + kLeg}});
        }
        parts.push_back(
            {"post-" + std::to_string(leg), {x, kSeat + kLeg, kHalf - kLeg}, {x + kLeg, kBack, kHalf}});
    }
    parts.push_back({"seat", {-kHalf, kSeat, -kHalf}, {kHalf, kSeat + kLeg, kHalf}});
    parts.push_back(
        {"rest", {-kHalf + kLeg, kBack - 0.18, kHalf - 0.02}, {kHalf - kLeg, kBack, kHalf - 0.005}});
    return parts;
}

}  // namespace lanthorn::scene_generator
