// Furniture as closed boxes that touch but never overlap. Metres; it stands on y = 0.
#pragma once

#include <string>
#include <vector>

#include "tools/scene_generator/shapes.h"

namespace lanthorn::scene_generator {

struct Part {
    std::string name;
    dvec3 low, high;
};
// All of them as one shape.
Shape whole(const std::vector<Part>& parts);

// A case of boards, open at the front (+z), its back on the plane z = 0: sides, back and `levels` boards
// between the lowest and the top. `size`: outer. `heights`, where it is not null: of the boards' upper sides,
// but for the top's.
std::vector<Part> shelf_parts(const dvec3& size, int levels, std::vector<double>* heights = nullptr);

// A seat on four legs of 3 cm, two of which go on upwards and carry a back rest; it looks along -z.
std::vector<Part> chair_parts();

}  // namespace lanthorn::scene_generator
