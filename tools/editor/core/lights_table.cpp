#include "tools/editor/core/lights_table.h"

#include <algorithm>

#include "tools/editor/core/node_path.h"

namespace lanthorn::editor {

std::vector<LightRow> lights_table(const EditModel& model) {
    std::vector<std::size_t> users(model.lights.size(), 0);
    const std::vector<std::uint32_t> order = model.in_order();
    for (const std::uint32_t node : order) {
        if (light_of(model, node) != nullptr) {
            ++users[model.node(node).light];
        }
    }
    std::vector<LightRow> rows;
    for (const std::uint32_t node : order) {
        const Light* light = light_of(model, node);
        if (light == nullptr) {
            continue;
        }
        LightRow row;
        row.node = node;
        row.path = path_of(model, node);
        row.name = called(model, node);
        row.type = light->type;
        const float most = std::max({light->colour.x, light->colour.y, light->colour.z});
        row.colour = most > 0 ? light->colour / most : light->colour;
        row.candela = lux_at_one_metre(*light);  // the same number
        row.lumen = lumen(*light);
        row.lux = lux_at_one_metre(*light);
        row.kelvin = kelvin_of(light->colour);
        row.range = light->range;
        row.at = dvec3(model.world_matrix(node)[3]);
        row.shown = model.is_shown(node);
        row.users = users[model.node(node).light];
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace lanthorn::editor
