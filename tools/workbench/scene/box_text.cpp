// A box that a scene gets, as text.
#include <fmt/format.h>

#include "lanthorn/core/error.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/workbench/scene/comma_numbers.h"

namespace lanthorn::workbench {

PlacedBox box_of(const std::string& text) {
    const auto numbers = comma_numbers(text);
    if (!numbers || numbers->size() != 4 || !(numbers->back() > 0)) {
        throw InputError(
            fmt::format("--box: found '{}', expected X,Y,Z,SIDE: metres, the side more than 0", text));
    }
    const std::vector<double>& n = *numbers;
    return {{n[0], n[1], n[2]}, n[3]};
}

std::string text_of(const PlacedBox& box) {
    return fmt::format("{},{},{},{}", box.centre.x, box.centre.y, box.centre.z, box.side);
}

}  // namespace lanthorn::workbench
