// All lights of a scene, a row each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/editor/core/edit_model.h"
#include "tools/editor/core/light_units.h"

namespace lanthorn::editor {

struct LightRow {
    std::uint32_t node = kNone;  // kNone: a guest, which is not in the file
    std::string path, name;
    LightType type = LightType::point;
    vec3 colour{1};         // linear Rec. 709, its largest part 1
    double candela = 0;     // times the colour's luminance; lux for directional lights
    double lumen = 0;       // 0 for directional lights
    double lux = 0;         // at 1 m on its axis; of directional lights anywhere
    Kelvin kelvin;          // of the colour
    double range = 0;       // metres; infinite: no cut-off
    dvec3 at{0};            // in the world
    bool shown = true;      // neither it nor one above is hidden
    std::size_t users = 1;  // nodes that share the light: an edit of one alters all
};

// In the order of the scene. O(nodes).
std::vector<LightRow> lights_table(const EditModel& model);

}  // namespace lanthorn::editor
